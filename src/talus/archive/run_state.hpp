#pragma once
// run.state: what a run knows after some of its rocks, so that it can go on from there or be merged with others. It
// needs neither the project nor its terrain to be read again, but to go on.
//
// The file: "talus run state\n", the format's number, the header's length, the header (which begins with the version of
// the program: of another one it is not read further), its checksum, what the observers saved, and the checksum of all
// before it. Numbers are little-endian.

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
inline constexpr std::uint32_t run_state_format = 2;

struct RunStateHeader {
  RunDescription description;
  RockRange range;             // that the run was to do
  std::optional<Shard> shard;  // nothing: the whole campaign
  std::uint64_t done = 0;      // the state is that of rocks range.first to done - 1
  double seconds = 0;          // spent on them
  int threads = 1;
  std::vector<TableMark> tables;

  [[nodiscard]] bool is_complete() const { return done == range.last; }
  [[nodiscard]] RockRange rocks() const { return {range.first, done}; }
};

/// What a state says of the run; the same in all states of one.
[[nodiscard]] std::string saved(const RunDescription& description);

/// Writes the file: it is there whole, and on the disk, or as it was before. In memory there is no more than a megabyte
/// of it at a time. Throws BadInput where it cannot be written.
void write_run_state(const std::filesystem::path& file, const RunStateHeader& header,
                     std::span<SummingObserver* const> observers);
/// The same with the description as it is saved, for those who write many.
void write_run_state(const std::filesystem::path& file, const RunStateHeader& header, std::string_view description,
                     std::span<SummingObserver* const> observers);

/// The header alone: quick, whatever was saved behind it. Throws BadInput that names the file and says what is wrong
/// with it: not there, not a state, of another version, cut short, or damaged.
[[nodiscard]] RunStateHeader read_run_state_header(const std::filesystem::path& file);

/// Adds what the file holds to observers made for the same description, in the order in which they were saved. Throws
/// BadInput as above, before anything is added if the file is not as it was written.
void merge_run_state(const std::filesystem::path& file, std::span<SummingObserver* const> observers);

/// The same of bytes in memory, for those who got them otherwise. Throws BadBytes.
[[nodiscard]] RunStateHeader read_header(std::string_view bytes);
void merge_state(std::string_view bytes, std::span<SummingObserver* const> observers);

}  // namespace talus
