#include "http/arrays.hpp"
#include "results/drawn_paths.hpp"
#include "routes/results.hpp"

namespace talus::server {

namespace {

Json names_of_reasons() {
  Json names = Json::array();
  for (int k = 0; k < end_reason_count; ++k) names.push_back(name(static_cast<EndReason>(k)));
  return names;
}

Json names_of_states() {
  using enum PathState;
  Json names = Json::array();
  for (const PathState state : {projectile, impact, sliding, rolling, barrier, ended}) names.push_back(name(state));
  return names;
}

}  // namespace

void add_path_routes(Router& router, RunStore& runs, RunModels& models) {
  router.get(one_run + "/paths", [&](const Call& call) {
    constexpr std::uint64_t most = 100'000;
    const std::uint64_t rocks = call.query_number("rocks", 10'000, most);
    const Run run = runs.find(call.part(1));
    const auto folder = results_folder(run);
    const auto built = models.find(run);
    const DrawnPaths paths = drawn_paths(folder, read_summary(run), rocks, built ? &built->model : nullptr);
    Arrays arrays({{"total", paths.total},
                   {"origin", {paths.origin.x(), paths.origin.y(), paths.origin.z()}},
                   {"sources", paths.source_names.list()},
                   {"seeders", paths.seeder_names.list()},
                   {"reasons", names_of_reasons()},
                   {"states", names_of_states()},
                   {"barriers", paths.barrier_names}});
    arrays.add("rocks", std::span<const std::uint32_t>(paths.rocks));
    arrays.add("starts", std::span<const std::uint32_t>(paths.starts));
    arrays.add("times", std::span<const float>(paths.times));
    arrays.add("positions", std::span<const float>(paths.positions));
    arrays.add("speeds", std::span<const float>(paths.speeds));
    arrays.add("energies", std::span<const float>(paths.energies));
    arrays.add("heights", std::span<const float>(paths.heights));
    arrays.add("states", std::span<const std::uint8_t>(paths.states));
    arrays.add("sources", std::span<const std::uint16_t>(paths.sources));
    arrays.add("seeders", std::span<const std::uint16_t>(paths.seeders));
    arrays.add("reasons", std::span<const std::uint8_t>(paths.reasons));
    arrays.add("masses", std::span<const float>(paths.masses));
    arrays.add("max_energies", std::span<const float>(paths.max_energies));
    arrays.add("max_heights", std::span<const float>(paths.max_heights));
    arrays.add("barriers", std::span<const std::uint32_t>(paths.barriers));
    return arrays.answer();
  });
}

}  // namespace talus::server
