// A random TIN of two million triangles, lumped mass: rocks per second on one core, and where the time goes.
//
// The rough slope (rough_slope.hpp), with points shifted on plan by up to 0.2 m (more would fold it). Friction of 46
// degrees gives about 25 impacts per rock. Usage: bench_tin [rocks] [sphere]

#include <cstdlib>
#include <cstring>

#include "common.hpp"
#include "rough_slope.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/meshing/cleaning.hpp"

using namespace talus;

namespace {

RawMesh random_tin() {
  const bench::RoughSlope slope(bench::side + 1);
  RawMesh mesh;
  for (int j = 0; j < bench::side; ++j) {
    for (int i = 0; i < bench::side; ++i) {
      const auto shake = uniform_pair(11, static_cast<std::uint64_t>(j * bench::side + i), Stream::slope_vertex, 0);
      const double x = i + 0.4 * (shake[0] - 0.5), y = j + 0.4 * (shake[1] - 0.5);
      mesh.vertices.emplace_back(x, y, slope.height(x, y));
    }
  }
  for (std::uint32_t j = 0; j + 1 < bench::side; ++j) {
    for (std::uint32_t i = 0; i + 1 < bench::side; ++i) {
      const std::uint32_t a = j * bench::side + i, b = a + 1, c = a + bench::side, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

TriangleMesh surface_of(const CleanMesh& mesh) {
  std::vector<TriangleMesh::Corners> neighbours;
  for (const auto& sides : mesh.neighbours) {
    TriangleMesh::Corners beyond;
    for (std::size_t k = 0; k < 3; ++k) beyond[k] = sides[k] ? (*sides[k]).index : TriangleMesh::no_neighbour;
    neighbours.push_back(beyond);
  }
  return TriangleMesh(mesh.vertices, mesh.triangles, neighbours);
}

// Every flight of some rocks, as a query on the terrain.
struct Flight {
  Parabola path;
  double duration;
};

std::vector<Flight> flights_of(const Model& model, std::uint64_t rocks) {
  Simulator simulator(model);
  std::vector<Flight> flights;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    (void)simulator.simulate(rock, true);
    const auto& rows = simulator.log().rows;
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
      if (rows[k].state != PathState::projectile) continue;
      const Motion& m = rows[k].motion;
      flights.push_back({{m.position, m.velocity, model.laws.gravity}, rows[k + 1].motion.time - m.time});
    }
  }
  return flights;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t rocks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
  const bool sphere = argc > 2 && std::strcmp(argv[2], "sphere") == 0;
  CleanMesh mesh;
  const RawMesh raw = random_tin();
  const double cleaning = bench::seconds([&] { mesh = clean(raw); });
  std::optional<TriangleMesh> surface;
  const double building = bench::seconds([&] { surface.emplace(surface_of(mesh)); });
  fmt::print("random TIN: {} triangles; cleaned in {:.2f} s, tree built in {:.2f} s; {:.1f} bytes per triangle\n",
             surface->facet_count(), cleaning, building,
             static_cast<double>(surface->bytes()) / static_cast<double>(surface->facet_count()));

  const Model model = bench::model_on(std::move(*surface), rocks,
                                      sphere ? RockModel::rigid_sphere : RockModel::lumped_mass, bench::side);
  bench::EndHash ends;
  Observer* const observers[] = {&ends};
  const CampaignOutcome outcome = run_campaign(model, observers, {1, nullptr, {}});
  const double impacts = static_cast<double>(ends.events);
  fmt::print(
      "{}: {} rocks, 1 thread, {:.2f} s, {:.0f} rocks/s, {:.1f} impacts per rock, {:.0f} ns per impact, hash {:016x}\n",
      sphere ? "rigid sphere" : "lumped mass", outcome.done, outcome.seconds,
      static_cast<double>(outcome.done) / outcome.seconds, impacts / static_cast<double>(outcome.done),
      outcome.seconds * 1e9 / impacts, ends.hash());
  bench::print_reasons(ends);

  // Where the time goes: the queries of the same flights alone.
  const auto& tin = std::get<TriangleMesh>(*model.surface);
  const double radius = sphere ? sphere_of_mass(1000, 2700).radius : 0;
  const auto flights = flights_of(model, std::min<std::uint64_t>(rocks, 5000));
  double tested = 0, met = 0, highest = 0;
  for (const Flight& flight : flights) tested += tin.facets_tested(flight.path, radius, 600);
  const double contacts = bench::seconds([&] {
    for (const Flight& flight : flights) met += tin.first_contact(flight.path, radius, 600) ? 1 : 0;
  });
  const double heights = bench::seconds([&] {
    for (const Flight& flight : flights) highest = tin.max_height(flight.path, flight.duration, highest);
  });
  const double count = static_cast<double>(flights.size());
  fmt::print(
      "{:.0f} flights: {:.1f} facets tested per flight; first contact {:.0f} ns, bounce height {:.0f} ns per flight "
      "({:.0f} met the ground, highest {:.2f} m)\n",
      count, tested / count, contacts * 1e9 / count, heights * 1e9 / count, met, highest);
}
