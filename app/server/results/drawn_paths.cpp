#include "results/drawn_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/io/csv_reader.hpp"
#include "talus/io/path_arcs.hpp"
#include "talus/io/path_reader.hpp"
#include "talus/io/run_facts.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

template <std::size_t n>
constexpr std::size_t place_of(const std::array<std::string_view, n>& columns, std::string_view name) {
  for (std::size_t k = 0; k < n; ++k)
    if (columns[k] == name) return k;
  throw "no such column";  // refused while compiling
}

/// How high points are above the ground.
class HeightAboveGround {
 public:
  explicit HeightAboveGround(const Model* model) : model_(model) {}

  [[nodiscard]] float operator()(const Vec3& place) const {
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    // A section that varies stands elsewhere for every rock.
    if (model_ == nullptr || model_->varying) return unknown;
    const Vec3 p = model_->frame.local_from_global(place);
    // A rock on the ground may be a rounding beneath it.
    constexpr double slack = 1e-3;
    const auto ground =
        std::visit([&](const auto& surface) { return surface.elevation(p.x(), p.y(), p.z() + slack); }, model_->surface);
    return ground ? static_cast<float>(std::max(0.0, p.z() - *ground)) : unknown;
  }

 private:
  const Model* model_;
};

/// What endpoints.csv says of the rocks.
void read_endpoints(const fs::path& file, DrawnPaths& paths) {
  constexpr auto at = [](std::string_view name) { return place_of(io::endpoint_columns, name); };
  io::CsvReader row(file, io::endpoint_columns);
  std::size_t k = 0;
  while (k < paths.rocks.size() && row.next()) {
    if (static_cast<std::uint64_t>(row.whole_number(at("rock"))) != paths.rocks[k]) continue;
    paths.seeders[k] = static_cast<std::uint16_t>(paths.seeder_names.number(row.text(at("seeder"))));
    for (int reason = 0; reason < end_reason_count; ++reason)
      if (row.text(at("end_reason")) == name(static_cast<EndReason>(reason)))
        paths.reasons[k] = static_cast<std::uint8_t>(reason);
    paths.masses[k] = static_cast<float>(row.number(at("mass_kg")));
    paths.max_energies[k] = static_cast<float>(row.number(at("max_ke_J")) / 1000);
    paths.max_heights[k] = static_cast<float>(row.number(at("max_bounce_m")));
    ++k;
  }
}

void read_hits(const fs::path& file, DrawnPaths& paths) {
  constexpr auto at = [](std::string_view name) { return place_of(io::barrier_columns, name); };
  constexpr std::uint32_t most = 32;
  if (paths.barrier_names.empty()) return;
  Names names(paths.barrier_names);
  io::CsvReader row(file, io::barrier_columns);
  auto next = paths.rocks.begin();
  while (row.next()) {  // in the order of the rocks
    const auto rock = static_cast<std::uint64_t>(row.whole_number(at("rock")));
    while (next != paths.rocks.end() && *next < rock) ++next;
    if (next == paths.rocks.end()) return;
    const std::uint32_t barrier = names.number(row.text(at("barrier")));
    if (*next == rock && barrier < most)
      paths.barriers[static_cast<std::size_t>(next - paths.rocks.begin())] |= 1u << barrier;
  }
}

}  // namespace

DrawnPaths drawn_paths(const fs::path& folder, const Json& summary, std::uint64_t rocks, const Model* model) {
  const io::RunFacts facts = io::read_run_facts(folder);
  DrawnPaths paths;
  paths.source_names = Names(names_of(summary.value("sources", Json::array())));
  paths.seeder_names = Names(names_of(summary.at("project").value("seeder", Json::array())));
  paths.barrier_names = names_of(summary.value("barriers", Json::array()));
  paths.total = facts.with_path.count_before(summary.at("rocks").at("done").get<std::uint64_t>());

  const io::EvenChoice chosen(rocks, paths.total);
  const HeightAboveGround height(model);
  std::uint64_t number = 0;
  io::PathReader reader(folder / "paths.csv");
  bool has_origin = false;
  while (paths.rocks.size() < chosen.count() &&
         reader.next([&](std::uint64_t) { return chosen.contains(number++); })) {
    const io::Path& path = reader.path();
    if (!has_origin) paths.origin = Vec3(path.rows[0].position_m.data()).array().round();
    has_origin = true;
    paths.rocks.push_back(static_cast<std::uint32_t>(path.rock));
    paths.starts.push_back(static_cast<std::uint32_t>(paths.times.size()));
    paths.sources.push_back(static_cast<std::uint16_t>(paths.source_names.number(facts.source_of(path.rock))));
    constexpr double tolerance = 0.05;  // [m]
    io::for_points_along(path, tolerance, [&](const io::PathPoint& point) {
      const Vec3 place(point.position_m.data());
      paths.times.push_back(static_cast<float>(point.time_s));
      for (int axis = 0; axis < 3; ++axis)
        paths.positions.push_back(static_cast<float>(place[axis] - paths.origin[axis]));
      paths.speeds.push_back(static_cast<float>(Vec3(point.velocity_m_s.data()).norm()));
      paths.energies.push_back(static_cast<float>(point.ke_total_J / 1000));
      paths.heights.push_back(height(place));
      paths.states.push_back(static_cast<std::uint8_t>(point.state));
    });
  }
  paths.starts.push_back(static_cast<std::uint32_t>(paths.times.size()));
  const std::size_t count = paths.rocks.size();
  paths.seeders.resize(count);
  paths.reasons.resize(count);
  paths.masses.resize(count);
  paths.max_energies.resize(count);
  paths.max_heights.resize(count);
  paths.barriers.resize(count);
  read_endpoints(folder / "endpoints.csv", paths);
  read_hits(folder / "barriers.csv", paths);
  return paths;
}

}  // namespace talus::server
