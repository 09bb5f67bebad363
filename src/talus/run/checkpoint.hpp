#pragma once
// States of a run that are written while it runs, and what a later run does with them.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "talus/archive/run_state.hpp"
#include "talus/archive/table_files.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {

/// Writes FOLDER/run.state now and then: tables first, so that a state never tells of rows that are not on the disk.
class Checkpoints {
 public:
  using Clock = std::chrono::steady_clock;

  /// `begun` is the header as it is before the first rock of this run, without its description, `every` the time
  /// between two checkpoints [s], 0 for none. Sums and tables must outlive it.
  Checkpoints(const std::filesystem::path& folder, RunStateHeader begun, const RunDescription& description,
              RunSums& sums, TableFiles& tables, double every);

  /// To be called when exactly the rocks before `next` are in the sums and tables. Writes if it is time: no sooner than
  /// asked for, and so that writing takes at most a twentieth of the time.
  void after(std::uint64_t next);
  /// Whether it is time: for those who must first gather what is to be written, and then say when they began to.
  [[nodiscard]] bool is_due() const;
  void write(std::uint64_t next, Clock::time_point begin = Clock::now());

  /// How far the last state goes that was written, or begun with: nothing where there is none to go on from.
  [[nodiscard]] const std::optional<RockRange>& last() const { return last_; }
  /// That there is a state from before.
  void begin_with(const RunStateHeader& state) { last_ = state.rocks(); }
  /// All rocks that the run was to do.
  [[nodiscard]] const RockRange& range() const { return header_.range; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Spent on the run so far, those before it included [s].
  [[nodiscard]] double seconds() const;

 private:
  std::filesystem::path file_;
  RunStateHeader header_;    // of the next state
  std::string description_;  // of the run, as it is saved
  double seconds_before_;    // of earlier runs
  RunSums& sums_;
  TableFiles& tables_;
  double every_;
  std::optional<RockRange> last_;
  Clock::time_point begin_ = Clock::now(), written_ = begin_;
  Clock::duration cost_{};
};

/// What a run that was asked to go on finds in its folder.
struct Found {
  std::optional<RunStateHeader> state;  // to go on from
  bool is_complete = false;             // there is nothing left to do
  std::string lacks;                    // of results without a state: the file that is missing
};

/// Throws BadInput where there is a state that cannot be gone on from: damaged, of another program, of other rocks, or
/// of a project that was changed since; what was changed is said. The same of results without a state.
[[nodiscard]] Found find_checkpoint(const std::filesystem::path& folder, const RunDescription& description,
                                    const RockRange& range, const std::optional<Shard>& shard);

/// Why results of one description do not belong to those of another; nothing where they do.
[[nodiscard]] std::optional<std::string> difference(const RunDescription& then, const RunDescription& now);

}  // namespace talus::project
