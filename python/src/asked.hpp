#pragma once
// Questions to the rocks of a run, in memory or in a folder: who crosses a line, or enters a polygon.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "memory_run.hpp"
#include "talus/lines/area_answer.hpp"
#include "talus/lines/asked_run.hpp"
#include "talus/lines/reopened_run.hpp"

namespace talus::python {

enum class PlaceKind { line, polygon, barrier };

/// A line or polygon as places, or as a text that a user gives (lines/line_input.hpp); or the name of a barrier.
struct GivenPlace {
  PlaceKind kind = PlaceKind::line;
  std::variant<std::vector<PlanPlace>, std::string> given;
};

/// Both throw BadInput. `height`: of the collector on a drawn line [m].
[[nodiscard]] AskedLine line_given(const Model& model, const GivenPlace& place, double height, Problems& warnings);
[[nodiscard]] AskedArea area_given(const Model& model, const GivenPlace& place, Problems& warnings);

struct Question {
  GivenPlace place;
  std::optional<std::array<double, 2>> kit;  // height [m] and energy [kJ]
  std::optional<double> section;             // length of the stretches of a profile [m]
  std::vector<std::string> settings;         // `design.KEY=VALUE`
};

class Asked {
 public:
  explicit Asked(std::shared_ptr<MemoryRun> run) : source_(std::move(run)) {}
  /// As ReopenedRun.
  Asked(const std::filesystem::path& folder, const std::filesystem::path& files)
      : source_(std::make_shared<ReopenedRun>(folder, files)) {}

  /// Throws BadInput.
  [[nodiscard]] RunAnswer answer(const Question& question) const;
  [[nodiscard]] RunAnswer ditch(double toe, double far_edge) const;
  [[nodiscard]] const StoredSources& sources() const { return run().sources(); }
  [[nodiscard]] const Model& model() const;

 private:
  [[nodiscard]] const project::Project& project() const;
  [[nodiscard]] const AskedRun& run() const;

  std::variant<std::shared_ptr<MemoryRun>, std::shared_ptr<ReopenedRun>> source_;
};

}  // namespace talus::python
