// Convergence under refinement: the same smooth ground on cells of 10 to 0.5 m, with the same rocks and draws. Prints
// for each cell size the runout, the share of rocks that reach a line, and their energy and height there, each with its
// sampling error (one standard error). For lumped mass and sphere, with and without roughness.
//
// Usage: bench_convergence [--rocks N] [--grazing DEGREES] [--knots METRES] [--finest METRES] [--spacing METRES]
//          [--tilts] [TERRAIN ...]
//   --knots 0: raw ground, the elevations of the file with cubic interpolation between them
//   --spacing: of bumps; --tilts: RocFall's law of roughness
//   TERRAIN: `arc`, `waves`, or FILE,west,south,east,north,x1,y1,x2,y2,distance (convergence_terrain.hpp). Without one,
//   `arc`, `waves` and the crater of examples/maungawhau.

#include <cstdlib>
#include <numeric>

#include "common.hpp"
#include "convergence_terrain.hpp"
#include "talus/rocks/energy.hpp"

using namespace talus;

namespace {

struct Options {
  std::uint64_t rocks = 2000;
  std::optional<double> grazing_deg;
  double knots = 10;   // of the smooth ground made from files [m]; 0: raw ground
  double spacing = 5;  // of bumps [m]
  RoughnessLaw roughness = RoughnessLaw::faces;
  double finest = 0.5;
  std::vector<std::string> terrains;
};

struct RockKind {
  RockModel model;
  double roughness_deg;
};

constexpr double radians = std::numbers::pi / 180;

/// What one rock comes to.
struct Arrival {
  double runout = 0;
  bool reaches = false;
  double energy = 0, height = 0;  // where it first reaches the line [J], [m]
};

class Arrivals : public Observer {
 public:
  std::vector<Arrival> rocks;

  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(); }
  void commit(ObserverPart& part) override {
    const Part& seen = static_cast<Part&>(part);
    rocks.insert(rocks.end(), seen.rocks.begin(), seen.rocks.end());
  }

 private:
  struct Part : ObserverPart {
    void see(const RockRecord& record, const RockLog& log) override {
      const RockOutcome& outcome = record.outcome;
      Arrival rock;
      rock.runout = (outcome.end.position - outcome.start.position).xy().norm();
      if (!log.hits.empty()) {
        const Passage& hit = log.hits.front();
        const Rock& body = record.body;
        rock.reaches = true;
        rock.energy = kinetic_energy(body, hit.motion);
        rock.height = hit.height;
      }
      rocks.push_back(rock);
    }
    std::vector<Arrival> rocks;
  };
};

Sampler spread(double mean, double std_dev, Bounds bounds) {
  return Sampler(Distribution{mean, DistributionKind::normal, std_dev, 3 * std_dev, 3 * std_dev}, bounds);
}

Material material_for(const RockKind& kind, const Options& options) {
  Material material;
  material.normal_restitution = spread(0.35, 0.04, {0, 1});
  material.tangential_restitution = spread(0.85, 0.04, {0, 1});
  material.friction_angle = Sampler(Distribution{33, DistributionKind::normal, 2, 6, 6}, {0, 80}, radians);
  if (kind.roughness_deg > 0) {
    material.roughness = RoughGround(
        Sampler(Distribution{0, DistributionKind::normal, kind.roughness_deg}, {}, radians), options.spacing);
  }
  material.dynamic_friction = Sampler(0.5);
  material.rolling_friction = spread(0.5, 0.03, {0, 1});
  return material;
}

/// The ends of a line parallel to the release line, on its right, as far as the terrain reaches; at most 400 m longer.
std::pair<Vec2, Vec2> line_of(const bench::SmoothTerrain& terrain) {
  const Vec2 along = (terrain.to - terrain.from).normalized(), right(along.y(), -along.x());
  const auto end = [&](const Vec2& start, const Vec2& heading) {
    Vec2 at = start + terrain.line_at * right;
    for (int k = 0; k < 200; ++k) {
      const Vec2 next = at + heading;
      if (next.x() < 10 || next.y() < 10 || next.x() > terrain.width - 10 || next.y() > terrain.height - 10) break;
      at = next;
    }
    return at;
  };
  return {end(terrain.from, -along), end(terrain.to, along)};
}

Model model_on(const bench::SmoothTerrain& terrain, double cell, const RockKind& kind, const Options& options) {
  Model model;
  RasterSurface surface(terrain.sampled(cell));
  model.ground = Ground(material_for(kind, options));
  model.laws.model = kind.model;
  if (kind.model == RockModel::rigid_sphere) model.laws.impact = RigidSphereImpact{.has_crsp_damping = true};
  model.laws.restitution_scaling.normal_speed = 9.144;
  model.laws.roughness = options.roughness;
  if (options.grazing_deg) model.laws.grazing = std::sin(*options.grazing_deg * radians);
  const Vec2 along = (terrain.to - terrain.from).normalized();

  Seeder seeder;
  seeder.name = "release";
  seeder.rocks = options.rocks;
  const Vec3 line[] = {{terrain.from.x(), terrain.from.y(), 0}, {terrain.to.x(), terrain.to.y(), 0}};
  seeder.where = ReleaseLines(line);
  seeder.step = even_step(count_places(seeder));
  seeder.above_surface = 3;
  seeder.size_of = SizeOf::diameter;
  seeder.size = spread(1.0, 0.2, {});
  seeder.density = Sampler(2700.0);
  seeder.direction = Vec3(along.y(), -along.x(), 0);
  seeder.horizontal = spread(2.0, 0.3, {});
  model.seeders.push_back(seeder);

  const auto [start, end] = line_of(terrain);
  Barrier collector;
  collector.name = "line";
  collector.is_collector = true;
  collector.set_panels(panels_over(surface.draped(start, end), 100, 0));
  model.barriers.push_back(std::move(collector));
  model.surface = std::move(surface);
  return model;
}

/// A figure with its standard error.
struct Figure {
  double value = 0, error = 0;
};

/// The error is half of the interval between the order statistics one standard deviation of their number to either
/// side.
Figure quantile(std::vector<double> values, double p) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  const auto at = [&](double rank) { return values[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))]; };
  const double spread = std::sqrt(n * p * (1 - p));
  return {at(n * p), 0.5 * (at(n * p + spread) - at(n * p - spread))};
}

Figure mean(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto n = static_cast<double>(values.size());
  const double middle = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return {middle, std::sqrt(squares / n / n)};
}

void print_row(const bench::SmoothTerrain& terrain, double cell, const RockKind& kind, const Options& options) {
  const Model model = model_on(terrain, cell, kind, options);
  Arrivals arrivals;
  bench::EndHash ends;
  Observer* const observers[] = {&arrivals, &ends};
  const CampaignOutcome outcome = run_campaign(model, observers, {1, nullptr, {}});
  std::vector<double> runouts, energies, heights;
  for (const Arrival& rock : arrivals.rocks) {
    runouts.push_back(rock.runout);
    if (!rock.reaches) continue;
    energies.push_back(rock.energy / 1000);
    heights.push_back(rock.height);
  }
  const auto n = static_cast<double>(runouts.size());
  const double share = static_cast<double>(energies.size()) / n;
  const Figure figures[] = {
      quantile(runouts, 0.5), quantile(runouts, 0.95),  {100 * share, 100 * std::sqrt(share * (1 - share) / n)},
      mean(energies),         quantile(energies, 0.95), mean(heights),
      quantile(heights, 0.95)};
  fmt::print("| {} | {} | {} | {:g} |", terrain.name, kind.model == RockModel::lumped_mass ? "lumped mass" : "sphere",
             kind.roughness_deg, cell);
  for (const Figure& figure : figures) fmt::print(" {:.3g} ± {:.2g} |", figure.value, figure.error);
  fmt::print(" {:.0f} | {:.1f} | {:.1f} | {:016x} |\n", 100.0 * static_cast<double>(ends.reasons[1]) / n,
             static_cast<double>(ends.events) / n, outcome.seconds, ends.hash());
  std::fflush(stdout);
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const auto number = [&] { return ++k < argc ? std::strtod(argv[k], nullptr) : 0.0; };
    if (word == "--rocks") {
      options.rocks = static_cast<std::uint64_t>(number());
    } else if (word == "--grazing") {
      options.grazing_deg = number();
    } else if (word == "--knots") {
      options.knots = number();
    } else if (word == "--spacing") {
      options.spacing = number();
    } else if (word == "--tilts") {
      options.roughness = RoughnessLaw::tilts;
    } else if (word == "--finest") {
      options.finest = number();
    } else {
      options.terrains.push_back(word);
    }
  }
  if (options.terrains.empty()) {
    options.terrains = {"arc", "waves",
                        TALUS_SOURCE_DIR "/examples/maungawhau/maungawhau.asc,10,10,590,850,290,120,430,125,60"};
  }
  return options;
}

bench::SmoothTerrain terrain_of(const std::string& text, double knots) {
  if (text == "arc") return bench::arc_terrain();
  if (text == "waves") return bench::waves_terrain();
  return bench::file_terrain(text, knots);
}

void run(const Options& options) {
  for (const std::string& text : options.terrains) {
    fmt::print("terrain: {}\n", text);
  }
  fmt::print(
      "{} rocks per row; knots of the smooth ground: {:g} m\n"
      "| terrain | model | roughness, deg | cell, m | median runout, m | 95 %, m | reach the line, % | mean energy "
      "there, kJ | 95 % | mean height there, m | 95 % | left the model, % | events | s | hash |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      options.rocks, options.knots);
  for (const std::string& text : options.terrains) {
    const bench::SmoothTerrain terrain = terrain_of(text, options.knots);
    for (const RockKind kind : {RockKind{RockModel::lumped_mass, 0}, RockKind{RockModel::lumped_mass, 10},
                                RockKind{RockModel::rigid_sphere, 0}, RockKind{RockModel::rigid_sphere, 10}}) {
      for (const double cell : {10.0, 5.0, 2.5, 1.0, 0.5}) {
        if (cell >= options.finest) print_row(terrain, cell, kind, options);
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(options_of(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
