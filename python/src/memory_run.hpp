#pragma once
// A run in memory: its rocks are simulated without a folder, and everything that a folder would contain is made of its
// rows and sums.

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>

#include "map_array.hpp"
#include "row_keeper.hpp"
#include "site.hpp"
#include "talus/archive/envelope_table.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/lines/asked_run.hpp"
#include "talus/run/run_results.hpp"

namespace talus::python {

/// After simulate() it can be used from any thread.
class MemoryRun {
 public:
  explicit MemoryRun(std::shared_ptr<const Site> site);

  /// Simulates all rocks, or the first ones if `stop` is set meanwhile; `done` counts. Throws OutOfMemory.
  void simulate(int threads, const std::atomic<bool>& stop, std::atomic<std::uint64_t>& done);

  [[nodiscard]] const Site& site() const { return *site_; }
  [[nodiscard]] const RunCourse& course() const { return course_; }
  [[nodiscard]] std::uint64_t rocks_done() const { return done_; }
  template <class Row>
  [[nodiscard]] const PackedRows& rows() const {
    return std::get<RowKeeper<Row>>(keepers_).rows();
  }
  /// Empty in 3D, or without maps.
  [[nodiscard]] EnvelopeTable envelopes();
  /// None in a section, or without maps.
  [[nodiscard]] std::vector<MapKind> map_kinds() const;
  [[nodiscard]] std::optional<MapArray> map(std::string_view name);
  /// The text of summary.json; without the size of the trajectories in trajectories.bin.
  [[nodiscard]] std::string summary_text();
  /// To be asked about lines, from the trajectories that it keeps. Throws BadInput if it keeps none.
  [[nodiscard]] const AskedRun& asked();
  /// Writes all files of the run. Throws BadInput; Stopped at the request of the thread's StopScope.
  void save(const std::filesystem::path& folder);

 private:
  void identify();

  template <class>
  struct KeepersOf;
  template <class... Row>
  struct KeepersOf<std::tuple<Row...>> {
    using Type = std::tuple<RowKeeper<Row>...>;
    static Type make(const Model& model, const TableRocks& rocks) {
      return {RowKeeper<Row>(TableContext::of(model), rocks)...};
    }
  };
  using Keepers = KeepersOf<ResultRows>;

  std::shared_ptr<const Site> site_;
  std::mutex mutex_;            // of everything that is made on request
  RunDescription description_;  // complete once is_identified_
  bool is_identified_ = false;
  project::RunSums sums_;
  Keepers::Type keepers_;
  RunCourse course_;
  std::uint64_t done_ = 0;
  std::unique_ptr<const AskedRun> asked_;  // once it is asked
};

}  // namespace talus::python
