#pragma once
// Checkpoints: states of a run that are written while it runs, from which a later run can resume.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "talus/archive/run_state.hpp"
#include "talus/archive/table_files.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {

/// Writes FOLDER/run.state at intervals: tables first, so that a state never refers to rows that are not on the disk.
class Checkpoints {
 public:
  using Clock = std::chrono::steady_clock;

  /// `begun` is the header before the first rock of this run, without its description; `every` is the time between
  /// checkpoints [s], 0 for none. Sums and tables must outlive it.
  Checkpoints(const std::filesystem::path& folder, RunStateHeader begun, const RunDescription& description,
              RunSums& sums, TableFiles& tables, double every);

  /// To be called when exactly the rocks before `next` are in the sums and tables. Writes if a checkpoint is due: no
  /// sooner than `every`, and so that writing takes at most a twentieth of the time.
  void after(std::uint64_t next);
  /// Whether a checkpoint is due: for callers that must first gather the sums, and then pass the time when they began.
  [[nodiscard]] bool is_due() const;
  void write(std::uint64_t next, Clock::time_point begin = Clock::now());

  /// The rocks of the last state that was written or resumed from; nullopt if there is none to resume from.
  [[nodiscard]] const std::optional<RockRange>& last() const { return last_; }
  /// Declares the state that the run resumes from.
  void begin_with(const RunStateHeader& state) { last_ = state.rocks(); }
  /// All rocks of the run.
  [[nodiscard]] const RockRange& range() const { return header_.range; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Time spent on the run so far, including earlier runs that it resumes [s].
  [[nodiscard]] double seconds() const;

 private:
  std::filesystem::path file_;
  RunStateHeader header_;    // of the next state
  std::string description_;  // of the run, serialised
  double seconds_before_;    // of earlier runs
  RunSums& sums_;
  TableFiles& tables_;
  double every_;
  std::optional<RockRange> last_;
  Clock::time_point begin_ = Clock::now(), written_ = begin_;
  Clock::duration cost_{};
};

/// What a run that is to be resumed finds in its folder.
struct Found {
  std::optional<RunStateHeader> state;  // to resume from
  bool is_complete = false;             // all rocks are done
  std::string lacks;                    // for results without a state: the file that is missing
};

/// Throws BadInput if a state cannot be resumed from: damaged, of another program, of other rocks, or of a project that
/// was changed since (with the changes). Likewise for results without a state.
[[nodiscard]] Found find_checkpoint(const std::filesystem::path& folder, const RunDescription& description,
                                    const RockRange& range, const std::optional<Shard>& shard);

/// Why results of two descriptions do not belong together; nullopt if they do.
[[nodiscard]] std::optional<std::string> difference(const RunDescription& then, const RunDescription& now);

}  // namespace talus::project
