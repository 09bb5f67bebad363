#include "talus/study/prepared_site.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/model/samples.hpp"
#include "talus/rocks/energy.hpp"
#include "talus/rocks/heights.hpp"

namespace talus::study {
/// Simulates one set after the other in one thread.
class PreparedSite::Worker {
 public:
  explicit Worker(const PreparedSite& site) : site_(site), model_(site.model_.without_surface()) {}

  /// Nullopt if it was stopped.
  std::optional<SetOutcome> run(std::span<const project::SettingNumber> parameters, const ParameterSet& set,
                                const SetRuns& how, std::uint64_t seed) {
    project::set_properties(site_.with(parameters, set), model_);
    model_.seed = seed;
    Simulator simulator(model_, *site_.model_.surface);
    const std::uint64_t rocks = std::min(how.rocks.value_or(model_.rocks()), model_.rocks());
    SetOutcome outcome;
    outcome.ends.reserve(rocks);
    SimulationOrder order;
    order.rocks = {0, rocks};
    order.keep_rows = [](std::uint64_t) { return false; };
    order.keep_pieces = how.keep_marks;
    order.see = [&](const RockRecord& record, const RockLog& log) { add(record, log, outcome); };
    order.stop = StopScope::current();
    if (simulator.simulate(order) < rocks) return std::nullopt;
    return outcome;
  }

 private:
  void add(const RockRecord& record, const RockLog& log, SetOutcome& outcome) const {
    const auto global = [&](const Vec3& local) { return model_.frame.global_from_local(local); };
    const RockOutcome& path = record.outcome;
    outcome.ends.push_back({record.rock, record.seeder, global(path.start.position), global(path.end.position),
                            path.reason, record.body.mass, record.body.radius, path.end.time, path.max_kinetic_energy,
                            path.max_bounce});
    for (const Passage& hit : log.hits) {
      outcome.crossings.push_back({record.rock, hit.barrier, global(hit.motion.position), hit.height,
                                   top_over(hit.lowest, hit.half_height_of(record.body.radius)), hit.motion.velocity.norm(),
                                   translational_energy(record.body, hit.motion),
                                   rotational_energy(record.body, hit.motion), hit.station, hit.outcome});
    }
    for (const Vec3& impact : log.impact_places) outcome.marks.push_back({record.rock, global(impact)});
  }

  const PreparedSite& site_;
  Model model_;
};

PreparedSite::PreparedSite(const project::Project& project, Problems& warnings)
    : project_(project::read_samples(project, warnings)), model_(project::build_model(project_, warnings)) {}

project::Project PreparedSite::with(std::span<const project::SettingNumber> parameters,
                                    const ParameterSet& values) const {
  project::Project project = project_;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (auto why = parameters[k].set(project, values[k])) {
      throw BadInput(Problem{.file = project_.file.string(),
                             .where = parameters[k].path(),
                             .what = std::move(*why),
                             .why = "a study can only use values that a project may have",
                             .hint = "Narrow the prior"});
    }
  }
  return project;
}

void PreparedSite::run(std::span<const project::SettingNumber> parameters, std::span<const ParameterSet> sets,
                       const SetRuns& how, const std::function<void(std::size_t, SetOutcome&&)>& take) const {
  for (const ParameterSet& set : sets) static_cast<void>(with(parameters, set));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads_for(how.threads)));
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(*this); });
  const StopScope* const scope = StopScope::current();
  std::atomic<bool> was_stopped{false};
  tbb::parallel_for(std::size_t{0}, sets.size(), [&](std::size_t k) {
    if (was_stopped.load(std::memory_order_relaxed)) return;
    const StopScope here(scope);
    if (auto outcome = workers.local().run(parameters, sets[k], how, how.seeds.empty() ? model_.seed : how.seeds[k])) {
      take(k, std::move(*outcome));
    } else {
      was_stopped = true;
    }
  });
  if (was_stopped) throw Stopped{};
}

SetOutcome PreparedSite::run(std::span<const project::SettingNumber> parameters, const ParameterSet& set,
                             const SetRuns& how) const {
  if (auto outcome = Worker(*this).run(parameters, set, how, how.seeds.empty() ? model_.seed : how.seeds.front()))
    return std::move(*outcome);
  throw Stopped{};
}

}  // namespace talus::study
