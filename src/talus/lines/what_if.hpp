#pragma once
// What if: the same rocks with a project's own values and with each variation of them, and what crosses a line or
// enters a polygon then.
//
// Every set has the same seed, so a rock draws the same numbers in all of them (common random numbers): it starts at
// the same place, and what differs between two sets is the effect of the values. Rocks are taken in the order in which
// a store would keep them (store/rock_choice.hpp), so that those that are done are a fair sample of the project's at
// any time, and after a stop.
//
// A rock is followed past the line by the code that asks a finished run (room `lines`), from the pieces of its path. So
// the figures with the project's own values are those of `talus line` on a run of the same rocks, but for the digits
// that a store leaves out along the ground.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/lines/area_answer.hpp"
#include "talus/lines/asked_line.hpp"
#include "talus/lines/what_if_factors.hpp"
#include "talus/model/design_plan.hpp"
#include "talus/results/design_result.hpp"
#include "talus/statistics/paired_differences.hpp"

namespace talus::what_if {

/// Nowhere: only how far rocks go is asked.
using AskedPlace = std::variant<std::monostate, AskedLine, AskedArea>;

/// What is told of the rocks that cross or enter, in the order of their values.
enum class Asked : std::uint8_t { energy_translational, energy_total, height, velocity };
[[nodiscard]] constexpr std::size_t place_of(Asked quantity) { return static_cast<std::size_t>(quantity); }

/// Of one set of values.
struct Figures {
  std::uint64_t rocks = 0;         // that cross or enter
  std::optional<RockShare> share;  // of all rocks of the set; nullopt: of nothing asked, or of no rocks
  /// The design percentile of what is asked; nullopt if no rock crosses.
  std::array<std::optional<Estimate>, MemberValues::quantities> percentile;
  /// The fence that the check asks for at a line, with all its factors, as in a design; nullopt if no rock crosses, or
  /// if the intervals have no upper ends.
  std::optional<KitDemand> demand, demand_at_upper_end;
  /// Of all rocks of the set: the median and the design percentile of the runout on plan [m], and the share that leaves
  /// the model.
  std::optional<Estimate> runout_median, runout;
  std::optional<RockShare> left;
};

[[nodiscard]] std::optional<Estimate> estimate_of(const std::optional<RockShare>& share);

/// Whether two figures differ by more than their intervals of sampling. Of few rocks an interval may lack an end: it
/// then reaches to half or to twice the value.
[[nodiscard]] bool are_apart(const Estimate& one, const Estimate& other);

/// With a variation minus without, for the same rocks.
struct Differences {
  std::uint64_t gained = 0, lost = 0;  // rocks that cross only with the variation; only without
  std::optional<Estimate> share;
  std::array<std::optional<Estimate>, MemberValues::quantities> percentile;
};

struct Answer {
  std::uint64_t rocks = 0, planned = 0;  // of each set; of the project
  Figures base;
  struct Varied {
    Figures figures;
    Differences differences;
  };
  std::vector<Varied> variations;  // in the order of the variations
};

/// Paths of the first rocks of each set, for a picture.
using Paths = std::vector<std::vector<Vec3>>;  // by rock; local

/// More rocks make intervals no narrower than what is known of the values.
inline constexpr std::uint64_t most_rocks = 200'000;

struct RunOptions {
  int threads = 0;                   // 0: as many as there are cores
  std::uint64_t rocks = most_rocks;  // of each set, at most
  /// The runs end in about this time: how many rocks that is follows from the speed of those before [s].
  std::optional<double> seconds{};
  /// Of so many rocks of each set the path is kept.
  std::uint64_t pictured = 0;
  /// After some of the rocks of all sets, about every second: how many are done, and how many there will be. Called by
  /// the thread that runs.
  std::function<void(std::uint64_t done, std::uint64_t planned)> progress{};
};

class WhatIf {
 public:
  /// `model`: of `project`; both must outlive the object. `basis`: percentile, confidence and the energy that the check
  /// takes.
  WhatIf(const project::Project& project, const Model& model, const project::DesignBasis& basis, AskedPlace place,
         const FactorChoice& choice, std::string_view where, Problems& warnings);
  ~WhatIf();
  WhatIf(const WhatIf&) = delete;
  WhatIf& operator=(const WhatIf&) = delete;

  [[nodiscard]] const std::vector<Variation>& variations() const;
  [[nodiscard]] const AskedPlace& place() const;
  [[nodiscard]] const Model& model() const;
  [[nodiscard]] RockModel rock_model() const;
  /// Confidence of all intervals, and percentile of the figures [%].
  [[nodiscard]] double confidence() const;
  [[nodiscard]] double percentile() const;
  /// Whether the energies are total, as the check of the standard takes them; otherwise translational.
  [[nodiscard]] bool takes_total_energy() const;
  /// The standard of the check; empty: none.
  [[nodiscard]] const std::string& standard() const;
  /// The energy that the check takes.
  [[nodiscard]] Asked energy() const {
    return takes_total_energy() ? Asked::energy_total : Asked::energy_translational;
  }

  /// Once. False if the thread's StopScope was requested to stop: rocks that are done in all sets are kept.
  bool run(const RunOptions& options);
  /// Of the rocks that are done. The same bits on any number of threads. `replicas`: of the bootstrap.
  [[nodiscard]] Answer answer(std::size_t replicas = 1000) const;
  /// Of each set, in the order of the answer: the project's own values first.
  [[nodiscard]] const std::vector<Paths>& paths() const;
  /// Of a set: the runout on plan of all its rocks, ascending [m].
  [[nodiscard]] std::vector<double> runouts(std::size_t set) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::what_if
