#pragma once
// What a run gathers over its rocks besides its tables, and what is written of it. A run and a merging of shards have
// this in common; the latter has no model.

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
#include "talus/project/project.hpp"
#include "talus/results/design_tally.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {

/// What makes maps of the model's rocks; nothing where the project wants none. Refers to the model.
[[nodiscard]] std::unique_ptr<MapObserver> map_observer(const Project& project, const Model& model);

/// `warnings`: those known before the run.
[[nodiscard]] RunDescription describe(const Project& project, const Model& model, const Problems& warnings);

/// The same less what nobody will write and need not be gathered: but a shard's maps are written by those who merge it.
[[nodiscard]] RunDescription describe_run(const Project& project, const Model& model, const Problems& warnings,
                                          const std::optional<Shard>& shard);

/// Of a campaign of so many rocks, those that the tables hold one by one.
[[nodiscard]] TableRocks table_rocks(const Project& project, std::uint64_t rocks);

/// All sums over rocks.
class RunSums {
 public:
  /// To observe the rocks of a model, which must outlive it. Maps only where the description plans any.
  RunSums(const RunDescription& description, const Project& project, const Model& model);
  /// To take what others have saved, and no rocks.
  explicit RunSums(const RunDescription& description);

  /// In the order in which they are saved: who adds one adds it to both constructors, and here.
  [[nodiscard]] std::vector<SummingObserver*> observers();
  [[nodiscard]] const Summary& summary() const { return summary_.summary(); }
  [[nodiscard]] MapObserver* maps() { return maps_.get(); }  // null: none
  /// How much memory maps may take [bytes]; 0: half of what this process may use.
  void limit_maps_memory(std::uint64_t bytes);
  /// Where maps take more, that in words; to be asked when sums are whole, that is after blocks.
  [[nodiscard]] std::optional<std::string> lacking_memory() const;
  [[nodiscard]] const DesignObserver* design() const { return design_ ? &*design_ : nullptr; }

 private:
  SummaryObserver summary_;
  std::optional<DesignObserver> design_;
  std::unique_ptr<MapObserver> maps_;
};

/// Writes maps, the design of barriers, what is made of the tables (which must be there whole), the report, as the
/// description plans them, and last summary.json: where it is, all is. What an earlier run recorded among its files and
/// this one does not make is removed. Of a shard, summary.json alone. Gives the warnings that came with the rocks.
/// Throws BadInput where a file cannot be written.
Problems write_results(const std::filesystem::path& folder, const RunDescription& description, RunSums& sums,
                       const RunCourse& course);

}  // namespace talus::project
