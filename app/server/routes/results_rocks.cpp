#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "http/arrays.hpp"
#include "results/drawn_blocks.hpp"
#include "results/drawn_paths.hpp"
#include "results/end_points.hpp"
#include "results/one_rock.hpp"
#include "routes/results.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/results/design_result.hpp"

namespace talus::server {

namespace {

Json end_reason_names() {
  Json names = Json::array();
  for (int k = 0; k < end_reason_count; ++k) names.push_back(name(static_cast<EndReason>(k)));
  return names;
}

Json state_names() {
  using enum PathState;
  Json names = Json::array();
  for (const PathState state : {projectile, impact, sliding, rolling, barrier, ended}) names.push_back(name(state));
  return names;
}

Json head(const EndPoints& rocks) {
  return {{"total", rocks.total},
          {"origin", {rocks.origin.x(), rocks.origin.y(), rocks.origin.z()}},
          {"sources", rocks.source_names.list()},
          {"seeders", rocks.seeder_names.list()},
          {"reasons", end_reason_names()},
          {"barriers", rocks.barrier_names}};
}

template <class T>
void add(Arrays& arrays, const char* name, const std::vector<T>& values) {
  arrays.add(name, std::span<const T>(values));
}

void add_rocks(Arrays& arrays, const EndPoints& rocks) {
  add(arrays, "rocks", rocks.rocks);
  add(arrays, "sources", rocks.sources);
  add(arrays, "seeders", rocks.seeders);
  add(arrays, "reasons", rocks.reasons);
  add(arrays, "masses", rocks.masses);
  add(arrays, "radii", rocks.radii);
  add(arrays, "max_energies", rocks.max_energies);
  add(arrays, "max_heights", rocks.max_heights);
  add(arrays, "barriers", rocks.barriers);
}

/// The place of release of each rock.
std::vector<std::uint32_t> releases_of(const EndPoints& rocks, const ReleaseSpots& spots) {
  std::vector<std::uint32_t> releases;
  for (const std::uint32_t rock : rocks.rocks) releases.push_back(static_cast<std::uint32_t>(spots.of_rock(rock)));
  return releases;
}

/// `releases`: of each rock, if they are known.
Answer paths_answer(const DrawnPaths& paths, Json header,
                    const std::optional<std::vector<std::uint32_t>>& releases = {}) {
  header.update(head(paths.rocks));
  header["states"] = state_names();
  Arrays arrays(std::move(header));
  add_rocks(arrays, paths.rocks);
  if (releases) add(arrays, "releases", *releases);
  add(arrays, "starts", paths.starts);
  add(arrays, "times", paths.times);
  add(arrays, "positions", paths.positions);
  add(arrays, "speeds", paths.speeds);
  add(arrays, "energies", paths.energies);
  add(arrays, "heights", paths.heights);
  add(arrays, "states", paths.states);
  return arrays.answer();
}

Answer blocks_answer(const DrawnBlocks& blocks) {
  Arrays arrays(Json{{"origin", {blocks.origin.x(), blocks.origin.y(), blocks.origin.z()}}});
  add(arrays, "rocks", blocks.rocks);
  add(arrays, "corner_starts", blocks.corner_starts);
  add(arrays, "triangle_starts", blocks.triangle_starts);
  add(arrays, "pose_starts", blocks.pose_starts);
  add(arrays, "corners", blocks.corners);
  add(arrays, "triangles", blocks.triangles);
  add(arrays, "times", blocks.times);
  add(arrays, "positions", blocks.positions);
  add(arrays, "turns", blocks.turns);
  return arrays.answer();
}

/// The rocks that a request for blocks names. Refuses (400) what is not a list of numbers.
std::vector<std::uint64_t> rocks_in(const Call& call) {
  call.only({"rocks"});
  const auto list = call.body.find("rocks");
  if (list == call.body.end()) throw Refusal(400, "rocks", "is missing");
  const auto is_number = [](const Json& each) { return each.is_number_unsigned(); };
  if (!list->is_array() || list->size() > DrawnBlocks::max_rocks || !std::ranges::all_of(*list, is_number))
    throw Refusal(400, "rocks", "is not valid",
                  fmt::format("expected a list of at most {} numbers of rocks", DrawnBlocks::max_rocks));
  return list->get<std::vector<std::uint64_t>>();
}

constexpr double share_confidence = 0.95;

/// A count of rocks, and the share behind it with its confidence interval.
Json with_share(const std::string& name, std::uint64_t rocks, std::uint64_t done) {
  const auto share = share_of(rocks, done, share_confidence);
  return {{"name", name}, {"rocks", rocks}, {"share", share ? Json{share->value, share->low, share->high} : Json()}};
}

Json json_of(const CountsSoFar& counts, const std::vector<std::string>& barriers) {
  Json reasons = Json::array(), hit = Json::array();
  for (std::size_t k = 0; k < counts.ends.size(); ++k)
    if (counts.ends[k] > 0) reasons.push_back(with_share(name(static_cast<EndReason>(k)), counts.ends[k], counts.done));
  for (std::size_t k = 0; k < barriers.size(); ++k)
    hit.push_back(with_share(barriers[k], counts.rocks_hit[k], counts.done));
  return {{"done", counts.done},
          {"planned", counts.planned},
          {"confidence", share_confidence},
          {"end_reasons", std::move(reasons)},
          {"rocks_hit", std::move(hit)}};
}

}  // namespace

void add_rock_routes(Router& router, RunStore& runs, RunModels& models, AskedRuns& asked) {
  router.get(one_run + "/paths", [&](const Call& call) {
    const std::uint64_t wanted = call.query_number("rocks", 10'000, 100'000);
    const Run run = runs.find(call.part(1));
    const auto folder = results_folder(run);
    const auto built = models.find(run);
    const DrawnPaths paths =
        drawn_paths(folder, read_facts(run), wanted, built ? &built->model : nullptr, rocks_passing(call, run, asked));
    return paths_answer(paths, {{"blocks", built && has_blocks(built->model)}},
                        built ? std::optional(releases_of(paths.rocks, *asked.releases(run))) : std::nullopt);
  });
  router.post(one_run + "/blocks", [&](const Call& call) {
    const std::vector<std::uint64_t> rocks = rocks_in(call);
    const Run run = runs.find(call.part(1));
    const auto folder = results_folder(run);
    const auto built = models.find(run);
    if (!built)
      throw Refusal(404, run.name, "the blocks of this run are not available",
                    "the files of the project have changed since");
    for (const std::uint64_t rock : rocks)
      if (rock >= built->model.rocks())
        throw Refusal(404, std::to_string(rock), "there is no such rock", "it was not run");
    return blocks_answer(drawn_blocks(folder, built->model, rocks));
  });
  router.get(one_run + "/so_far", [&](const Call& call) {
    const auto watch = runs.watch(call.part(1));
    const DrawnPaths paths = watch->paths();
    return paths_answer(paths, {{"so_far", json_of(watch->counts(), paths.rocks.barrier_names)}});
  });
  router.get(one_run + "/endpoints", [&](const Call& call) {
    const std::uint64_t wanted = call.query_number("rocks", 100'000, 1'000'000);
    const Run run = runs.find(call.part(1));
    const auto folder = results_folder(run);
    const EndPoints rocks = end_points(folder, read_facts(run), wanted, rocks_passing(call, run, asked));
    const auto built = models.find(run);
    Arrays arrays(head(rocks));
    add_rocks(arrays, rocks);
    if (built) add(arrays, "releases", releases_of(rocks, *asked.releases(run)));
    add(arrays, "positions", rocks.positions);
    return arrays.answer();
  });
  router.get(one_run + "/rocks/([0-9]{1,19})", [&](const Call& call) {
    const Run run = runs.find(call.part(1));
    return json_answer(
        one_rock(results_folder(run), std::stoull(call.part(2)), read_facts(run), [&] { return models.find(run); }));
  });
}

}  // namespace talus::server
