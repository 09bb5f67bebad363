#pragma once
// The sums of a run over its rocks, and the results written from them and the tables. Shared by a run and a merge of
// shards, which has no model.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/archive/summary_json.hpp"
#include "talus/archive/table_rocks.hpp"
#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/text_sink.hpp"
#include "talus/project/project.hpp"
#include "talus/results/design_result.hpp"
#include "talus/results/design_tally.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/results/summary.hpp"
#include "talus/store/store_observer.hpp"

namespace talus::project {

/// The maps that a run of the model makes.
[[nodiscard]] MapSelection map_selection(const Project& project, const Model& model);

/// The observer that makes maps of the model's rocks; null if the project has none. Refers to the model.
[[nodiscard]] std::unique_ptr<MapObserver> map_observer(const Project& project, const Model& model);

/// What a run counts and writes: its description without what identifies its inputs.
[[nodiscard]] RunDescription plan_of(const Project& project, const Model& model);
/// Adds that: the project, fingerprints and the model, which takes time on a large terrain. `warnings`: those known
/// before the run.
void identify(RunDescription& description, const Project& project, const Model& model, const Problems& warnings);
/// Both.
[[nodiscard]] RunDescription describe(const Project& project, const Model& model, const Problems& warnings);

/// As describe(), without maps that this program cannot write; but a shard keeps its maps, which are written when it is
/// merged.
[[nodiscard]] RunDescription describe_run(const Project& project, const Model& model, const Problems& warnings,
                                          const std::optional<Shard>& shard);

/// The rocks of a campaign of `rocks` rocks that have rows of their own in the tables.
[[nodiscard]] TableRocks table_rocks(const Project& project, std::uint64_t rocks);

/// All sums over rocks.
class RunSums {
 public:
  /// To observe the rocks of a model, which must outlive it. Has maps only if the description has.
  RunSums(const RunDescription& description, const Project& project, const Model& model);
  /// To merge saved sums, without observing rocks.
  explicit RunSums(const RunDescription& description);

  /// In the order in which they are saved. A new one must be added to both constructors and here.
  [[nodiscard]] std::vector<SummingObserver*> observers();
  [[nodiscard]] const Summary& summary() const { return summary_.summary(); }
  [[nodiscard]] MapObserver* maps() { return maps_.get(); }  // null: none
  /// The limit for the memory of maps [bytes]; 0: half of the memory available to this process.
  void limit_maps_memory(std::uint64_t bytes);
  /// A message if maps exceed the limit; to be called between blocks, when the sums are consistent.
  [[nodiscard]] std::optional<std::string> lacking_memory() const;
  [[nodiscard]] StoreObserver* store() { return store_.get(); }  // null: none
  [[nodiscard]] const DesignObserver* design() const { return design_ ? &*design_ : nullptr; }

 private:
  SummaryObserver summary_;
  std::optional<DesignObserver> design_;
  std::unique_ptr<MapObserver> maps_;
  std::unique_ptr<StoreObserver> store_;
};

/// What the sums of a run say: warnings about its rocks, and the design of barriers if there is a plan for it.
struct Findings {
  Problems warnings;
  std::optional<DesignResult> design;
};
[[nodiscard]] Findings findings_of(const RunDescription& description, const RunSums& sums, const RunCourse& course);

/// Writes summary.json with these warnings after those of the description.
void write_summary(TextSink& out, const RunDescription& description, const Problems& found,
                   const std::optional<DesignResult>& design, const RunSums& sums, const RunCourse& course);

/// What writing the results of a run came to.
struct WrittenResults {
  Problems warnings;                          // about the rocks
  std::optional<StoredRocks> trajectories{};  // in the store, if there is one
};

/// Writes maps, the store of trajectories, the design of barriers, the files derived from the tables (which must be
/// complete) and the report, as the description plans them, and last summary.json: if it exists, all files do. Removes
/// recorded files of an earlier run that this one does not write. Of a shard, only summary.json. Throws BadInput if a
/// file cannot be written.
WrittenResults write_results(const std::filesystem::path& folder, const RunDescription& description, RunSums& sums,
                             RunCourse course);

}  // namespace talus::project
