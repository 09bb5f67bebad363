#pragma once
// A project whose terrain, seeders and barriers are built once, to be run with many sets of parameters in memory.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "talus/barriers/barrier.hpp"
#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/parameter.hpp"
#include "talus/project/project.hpp"
#include "talus/rocks/motion.hpp"

namespace talus::study {

// Positions are in the project's coordinates.

/// Where and how one rock ended.
struct RockEnd {
  std::uint64_t rock = 0;  // its number in the campaign
  SeederId seeder;
  Vec3 release, end;  // of its centre [m]
  EndReason reason = EndReason::at_rest;
  double mass = 0, radius = 0;    // [kg], [m]
  double time = 0;                // from release to end [s]
  double max_kinetic_energy = 0;  // [J]
  double max_bounce = 0;          // rocks/heights.hpp [m]

  /// On plan [m].
  [[nodiscard]] double runout() const { return (end - release).xy().norm(); }
};

/// A rock that arrives at a barrier or collector.
struct Crossing {
  std::uint64_t rock = 0;
  BarrierId barrier;
  Vec3 position;                                           // [m]
  double height = 0;                                       // of the contact above the foot, along the face [m]
  double top = 0;                                          // of the top of the block, likewise [m]
  double speed = 0;                                        // [m/s]
  double translational_energy = 0, rotational_energy = 0;  // [J]
  double station = 0;                                      // along the line, on plan [m]
  BarrierOutcome outcome = BarrierOutcome::passed;
};

/// A rock strikes the ground.
struct Mark {
  std::uint64_t rock = 0;
  Vec3 position;  // of its centre [m]
};

/// The rocks of one set of parameters, in the order of their numbers.
struct SetOutcome {
  std::vector<RockEnd> ends;        // one for each rock
  std::vector<Crossing> crossings;  // none to several for each rock
  std::vector<Mark> marks;          // if requested
};

/// One value for each parameter, in their order.
using ParameterSet = std::vector<double>;

struct SetRuns {
  int threads = 0;          // 0: as many as there are cores
  bool keep_marks = false;  // costs time
  /// The rocks to simulate: 0 to rocks - 1; nullopt: all of the project. Rock numbers beyond the project's are not
  /// simulated.
  std::optional<std::uint64_t> rocks{};
  /// The seed of each set; empty: the project's, the same for all.
  std::vector<std::uint64_t> seeds{};
};

class PreparedSite {
 public:
  /// Builds the model of a checked project. Throws BadInput as `build_model` does; doubts are added to `warnings`.
  PreparedSite(const project::Project& project, Problems& warnings);

  [[nodiscard]] const project::Project& project() const { return project_; }
  /// With the project's own values.
  [[nodiscard]] const Model& model() const { return model_; }

  /// The project with these values. Throws BadInput if they cannot be.
  [[nodiscard]] project::Project with(std::span<const project::SettingNumber> parameters,
                                      const ParameterSet& values) const;

  /// Runs each set of parameters, several at the same time, each in one thread, and calls `take(k, outcome)` for set k
  /// as soon as it is done, from any thread. All sets have the same draws (common random numbers): what differs between
  /// two sets is the parameters' effect. The outcome of a set depends on nothing but the project and its values.
  /// Throws BadInput, before any run, if values cannot be; Stopped, if the thread's StopScope is requested to stop:
  /// sets in progress are then dropped.
  void run(std::span<const project::SettingNumber> parameters, std::span<const ParameterSet> sets, const SetRuns& how,
           const std::function<void(std::size_t, SetOutcome&&)>& take) const;
  /// One set, in this thread.
  [[nodiscard]] SetOutcome run(std::span<const project::SettingNumber> parameters, const ParameterSet& set,
                               const SetRuns& how = {}) const;

 private:
  class Worker;

  project::Project project_;
  Model model_;
};

}  // namespace talus::study
