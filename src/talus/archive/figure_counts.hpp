#pragma once
// The figures by which protection is designed, counted from the rows of a run's tables.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "talus/archive/convergence.hpp"
#include "talus/archive/run_summary.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/archive/uncertainty.hpp"

namespace talus {

/// The ensembles of a run of this project; 0: all rocks have the same parameters.
[[nodiscard]] std::uint64_t ensembles_of(const JsonValue& project);

class FigureCounts {
 public:
  /// Counts nothing.
  FigureCounts() = default;
  /// Of a whole run: the rocks of a part are not a random choice.
  explicit FigureCounts(const RunSummary& summary);

  void add(const TableReader<EndpointRow>& row);
  void add(const TableReader<HitRow>& row);
  [[nodiscard]] Convergence convergence() const { return convergence_ ? convergence_->result() : Convergence(); }
  [[nodiscard]] Uncertainty uncertainty() const { return uncertainty_ ? uncertainty_->result() : Uncertainty(); }

 private:
  std::optional<ConvergenceCount> convergence_;
  std::optional<UncertaintyCount> uncertainty_;
};

/// Counts the tables of a run's folder. Throws BadInput if they cannot be read.
[[nodiscard]] Uncertainty read_uncertainty(const std::filesystem::path& folder, const char* summary = "summary.json");

}  // namespace talus
