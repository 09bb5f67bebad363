#include "results/drawn_paths.hpp"

#include <algorithm>
#include <limits>
#include <system_error>

#include "talus/archive/path_arcs.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/export/stored_paths.hpp"

namespace talus::server {

namespace {

[[noreturn]] void refuse_other_tables(const std::filesystem::path& file) {
  throw BadInput(Problem{
      .file = file.string(), .what = "does not match endpoints.csv", .why = "rocks are missing in one of the two"});
}

/// Height of points above the ground, NaN if unknown.
class HeightAboveGround {
 public:
  explicit HeightAboveGround(const Model* model) : model_(model) {}

  [[nodiscard]] float operator()(const Vec3& place) const {
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    // A varying section differs between rocks.
    if (model_ == nullptr || model_->varying) return unknown;
    const Vec3 p = model_->frame.local_from_global(place);
    // A rock on the ground may be slightly below it by rounding.
    constexpr double slack = 1e-3;
    const auto ground = std::visit([&](const auto& surface) { return surface.elevation(p.x(), p.y(), p.z() + slack); },
                                   *model_->surface);
    return ground ? static_cast<float>(std::max(0.0, p.z() - *ground)) : unknown;
  }

 private:
  const Model* model_;
};

/// `rocks` paths of those in the store that have end points and pass the test.
DrawnPaths drawn_of_store(const std::filesystem::path& folder, const RunFacts& facts, std::uint64_t rocks,
                          const Model* model, const RockTest& passes) {
  const TrajectoryStore store(folder / trajectories_name);
  const TableContext context = path_context_of(store.facts());
  std::vector<std::uint64_t> all, drawn;
  for (const std::uint64_t rock : store.rocks())
    if (facts.in_tables.has_endpoint(rock) && (!passes || passes(rock))) all.push_back(rock);
  const EvenChoice choice(rocks, all.size());
  for (std::size_t k = 0; k < all.size(); ++k)
    if (choice.contains(k)) drawn.push_back(all[k]);
  DrawnPaths paths;
  paths.rocks = end_points(folder, facts, [&](std::uint64_t rock) { return std::ranges::binary_search(drawn, rock); });
  paths.rocks.total = all.size();
  if (paths.rocks.rocks.size() < drawn.size()) refuse_other_tables(folder / trajectories_name);
  StoredTrajectory trajectory;
  Path path;
  for (const std::uint64_t rock : drawn) {
    store.read(*store.find(rock), trajectory);
    path.rock = rock;
    path.rows.resize(trajectory.rows.size());
    for (std::size_t k = 0; k < path.rows.size(); ++k)
      fill(path.rows[k], context, trajectory.record, k, trajectory.rows[k]);
    add_path(paths, path, model);
  }
  paths.starts.push_back(static_cast<std::uint32_t>(paths.times.size()));
  return paths;
}

}  // namespace

void add_path(DrawnPaths& paths, const Path& path, const Model* model) {
  constexpr double tolerance = 0.05;  // of the arcs [m]
  const HeightAboveGround height(model);
  if (paths.starts.empty()) paths.rocks.origin = origin_near(vector(path.rows[0].position_m));
  paths.starts.push_back(static_cast<std::uint32_t>(paths.times.size()));
  for_points_along(path, tolerance, [&](const PathPoint& point) {
    const Vec3 place = vector(point.position_m);
    paths.times.push_back(static_cast<float>(point.time_s));
    for (std::size_t axis = 0; axis < 3; ++axis)
      paths.positions.push_back(static_cast<float>(place[axis] - paths.rocks.origin[axis]));
    paths.speeds.push_back(static_cast<float>(vector(point.velocity_m_s).norm()));
    paths.energies.push_back(static_cast<float>(point.ke_total_J / 1000));
    paths.heights.push_back(height(place));
    paths.states.push_back(static_cast<std::uint8_t>(point.state));
  });
}

DrawnPaths drawn_paths(const std::filesystem::path& folder, const RunFacts& facts, std::uint64_t rocks,
                       const Model* model, const RockTest& passes) {
  const TableRocks& tables = facts.in_tables;
  std::error_code no_store;
  if (facts.summary.rocks.done < facts.planned_rocks() && exists(folder / trajectories_name, no_store))
    return drawn_of_store(folder, facts, std::min(rocks, tables.paths()), model, passes);
  const ChosenRocks chosen(
      rocks, facts.summary.rocks.done, [&](std::uint64_t rock) { return tables.paths_before(rock); },
      [&](std::uint64_t rock) { return tables.has_path(rock); }, passes);
  const RockTest& wants = chosen.wants();
  DrawnPaths paths;
  paths.rocks = end_points(folder, facts, wants);
  paths.rocks.total = chosen.total();

  PathReader reader(folder / PathEventRow::file_name);
  while (paths.starts.size() < paths.rocks.rocks.size() && reader.next(wants)) {
    const Path& path = reader.path();
    if (path.rock != paths.rocks.rocks[paths.starts.size()]) refuse_other_tables(folder / PathEventRow::file_name);
    add_path(paths, path, model);
  }
  if (paths.starts.size() < paths.rocks.rocks.size()) refuse_other_tables(folder / PathEventRow::file_name);
  paths.starts.push_back(static_cast<std::uint32_t>(paths.times.size()));
  return paths;
}

}  // namespace talus::server
