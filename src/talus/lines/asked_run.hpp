#pragma once
// Questions to a finished run, answered from the paths of its rocks: for the server and `talus line`.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/core/problems.hpp"
#include "talus/lines/area_json.hpp"
#include "talus/lines/ditch_json.hpp"
#include "talus/lines/line_json.hpp"

namespace talus {

struct RunAnswer {
  nlohmann::ordered_json json;
  std::vector<std::uint64_t> rocks;  // that cross or enter, ascending
  Problems warnings;                 // why it should not be trusted as it is
};

/// Several threads may ask at the same time.
class AskedRun {
 public:
  /// `model`: of the run; it must outlive the object. `ways`: of its summary. Throws BadInput if the paths are of
  /// another run.
  AskedRun(const Model& model, std::unique_ptr<const RockPaths> paths, const std::optional<WaysSummary>& ways = {});

  [[nodiscard]] RunAnswer line(const project::DesignBasis& basis, const AskedLine& line,
                               const AnswerOptions& options) const;
  /// Short answers of many lines, which are followed together.
  [[nodiscard]] nlohmann::ordered_json lines(const project::DesignBasis& basis, std::span<const AskedLine> lines) const;
  [[nodiscard]] RunAnswer area(const project::DesignBasis& basis, const AskedArea& area,
                               const AnswerOptions& options) const;
  /// `confidence`: of the intervals. The rocks are those that get past the toe.
  [[nodiscard]] RunAnswer ditch(const Ditch& ditch, double confidence) const;

  [[nodiscard]] const StoredSources& sources() const { return sources_; }
  [[nodiscard]] const RockPaths& paths() const { return *paths_; }

 private:
  [[nodiscard]] nlohmann::ordered_json head() const;

  const Model& model_;
  std::unique_ptr<const RockPaths> paths_;
  StoredSources sources_;
  Problems warnings_;  // about the run
};

/// The length of sections of a profile, where none is given: about twenty on the line, 1, 2 or 5 times a power of ten
/// [m].
[[nodiscard]] double usual_section(const Barrier& line);

/// Kits for sliders of height and capacity: those of the design, and heights of 0.5 to 15 m in steps of 0.5 m, energies
/// up to 10,000 kJ.
void add_kits_for_sliders(project::DesignBasis& basis);

}  // namespace talus
