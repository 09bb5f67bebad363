#pragma once
// run.state: the state of a run after some of its rocks, to resume it or to merge it with others. Merging needs neither
// the project nor its terrain; resuming needs both.
//
// The file: "talus run state\n", the number of the format, the length of the header, the header, its checksum, the
// saved observers, and the checksum of everything before. The header begins with the version of the program; a file of
// another version is not read further. Numbers are little-endian.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/archive/table_files.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/results/record.hpp"

namespace talus {

inline constexpr const char* run_state_name = "run.state";
inline constexpr std::uint32_t run_state_format = 5;

struct RunStateHeader {
  RunDescription description;
  RockRange range;             // planned rocks of the run
  std::optional<Shard> shard;  // nullopt: the whole campaign
  std::uint64_t done = 0;      // the state covers rocks range.first to done - 1
  double seconds = 0;          // computing time
  int threads = 1;
  std::vector<TableMark> tables;

  [[nodiscard]] bool is_complete() const { return done == range.last; }
  [[nodiscard]] RockRange rocks() const { return {range.first, done}; }
};

/// The description of the run; the same in all its states.
[[nodiscard]] std::string saved(const RunDescription& description);

/// Writes the file atomically and syncs it to disk, with no more than a megabyte of it in memory. Throws BadInput if
/// that fails.
void write_run_state(const std::filesystem::path& file, const RunStateHeader& header,
                     std::span<SummingObserver* const> observers);
/// Overload with the description already saved, for repeated writes.
void write_run_state(const std::filesystem::path& file, const RunStateHeader& header, std::string_view description,
                     std::span<SummingObserver* const> observers);

/// Reads only the header, which is fast. Throws BadInput that names the file and the fault: missing, not a state, of
/// another version, truncated, or damaged.
[[nodiscard]] RunStateHeader read_run_state_header(const std::filesystem::path& file);

/// Adds the saved content to observers made for the same description, in the order in which they were saved. Throws
/// BadInput as above; a damaged file is refused before anything is added.
void merge_run_state(const std::filesystem::path& file, std::span<SummingObserver* const> observers);

/// Overload for bytes in memory. Throws BadBytes.
[[nodiscard]] RunStateHeader read_header(std::string_view bytes);
void merge_state(std::string_view bytes, std::span<SummingObserver* const> observers);

}  // namespace talus
