#include "talus/run/merge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/info.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "talus/archive/run_state.hpp"
#include "talus/archive/table_files.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/run/checkpoint.hpp"
#include "talus/run/finished_run.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {

namespace {

struct Part {
  std::filesystem::path folder;
  RunStateHeader state;
  [[nodiscard]] std::filesystem::path file() const { return folder / run_state_name; }
};

/// Runs `work` and collects its errors, so that all are reported.
void gather(Problems& problems, const auto& work) {
  try {
    work();
  } catch (const BadInput& bad) {
    problems.append(bad.problems());
  }
}
void throw_if_any(Problems& problems) {
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

bool has_state(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / run_state_name, ignored);
}

/// The folder itself, or its subfolders with a state, by name.
std::vector<std::filesystem::path> folders_with_state(const std::filesystem::path& folder) {
  if (has_state(folder)) return {folder};
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (has_state(entry.path())) found.push_back(entry.path());
  }
  if (found.empty()) {
    throw BadInput(Problem{.file = folder.string(),
                           .what = "there is no state of a run in this folder",
                           .why = error ? error.message() : "expected run.state here or in a subfolder",
                           .hint = "Name folders that `talus run --shard` has written"});
  }
  std::ranges::sort(found);
  return found;
}

std::vector<Part> read_parts(const std::vector<std::filesystem::path>& folders) {
  Problems problems;
  std::vector<Part> parts;
  for (const std::filesystem::path& folder : folders) {
    gather(problems, [&] {
      for (const auto& each : folders_with_state(folder)) {
        gather(problems, [&] { parts.push_back({each, read_run_state_header(each / run_state_name)}); });
      }
    });
  }
  throw_if_any(problems);
  return parts;
}

void check_that_they_belong_together(const std::vector<Part>& parts) {
  Problems problems;
  for (const Part& part : parts) {
    const auto why = difference(parts.front().state.description, part.state.description);
    if (!why) continue;
    problems.add({.file = part.file().string(),
                  .what = fmt::format("this run does not belong to that in {}", parts.front().folder.string()),
                  .why = *why,
                  .hint = "Merge runs of one project, unchanged, with one build of talus"});
  }
  throw_if_any(problems);
}

std::string text_of(const RockRange& rocks) {
  if (rocks.count() == 1) return fmt::format("rock {}", rocks.first);
  return fmt::format("rocks {} to {}", rocks.first, rocks.last - 1);
}

/// Expects the parts in the order of their rocks.
void check_that_none_is_double(const std::vector<Part>& parts) {
  Problems problems;
  const Part* longest = nullptr;  // of the earlier parts, the one that extends furthest
  for (const Part& part : parts) {
    const RockRange rocks = part.state.rocks();
    if (rocks.count() == 0) continue;
    if (longest != nullptr && rocks.first < longest->state.done) {
      const RockRange common{rocks.first, std::min(rocks.last, longest->state.done)};
      problems.add({.file = part.file().string(),
                    .what = fmt::format("{} {} also in {}", text_of(common), common.count() == 1 ? "is" : "are",
                                        longest->folder.string()),
                    .why = "every rock counts once",
                    .hint = "Leave out one of the two folders"});
    }
    if (longest == nullptr || rocks.last > longest->state.done) longest = &part;
  }
  throw_if_any(problems);
}

std::vector<RockRange> missing_rocks(const std::vector<Part>& parts) {
  std::vector<RockRange> missing;
  std::uint64_t next = 0;
  for (const Part& part : parts) {
    const RockRange rocks = part.state.rocks();
    if (rocks.first > next && rocks.count() > 0) missing.push_back({next, rocks.first});
    next = std::max(next, rocks.last);
  }
  const std::uint64_t all = parts.front().state.description.rocks;
  if (next < all) missing.push_back({next, all});
  return missing;
}

void refuse_missing(const std::vector<Part>& parts, const std::vector<RockRange>& missing) {
  Problems problems;
  for (const RockRange& rocks : missing) {
    const auto unfinished = std::ranges::find_if(
        parts, [&](const Part& part) { return !part.state.is_complete() && part.state.done == rocks.first; });
    Problem problem{.what = fmt::format("{} of {} {} missing", text_of(rocks), parts.front().state.description.rocks,
                                        rocks.count() == 1 ? "is" : "are")};
    if (unfinished != parts.end()) {
      problem.file = unfinished->file().string();
      problem.why = "this run did not finish";
      problem.hint = "Run it again with --resume, or merge what there is with --partial";
    } else {
      problem.file = "merge";
      problem.why = "no folder has them";
      problem.hint = "Name all folders, run the shards that have not been run, or merge what there is with --partial";
    }
    problems.add(std::move(problem));
  }
  throw_if_any(problems);
}

void check_tables(const std::vector<Part>& parts) {
  Problems problems;
  const auto names = [](const Part& part) {
    std::vector<std::string> list;
    for (const TableMark& mark : part.state.tables) list.push_back(mark.file_name);
    return list;
  };
  for (const Part& part : parts) {
    for (const TableMark& mark : part.state.tables) {
      gather(problems, [&] { (void)find_marked(part.folder, mark); });
    }
    if (names(part) != names(parts.front())) {
      problems.add(
          {.file = part.file().string(),
           .what = fmt::format("the tables are not those of {}", parts.front().folder.string()),
           .why = fmt::format("{} and {}", fmt::join(names(part), ", "), fmt::join(names(parts.front()), ", "))});
    }
  }
  throw_if_any(problems);
}

/// Appends the first `bytes` bytes of a file, without its first line unless requested: it is the same in all parts.
void append_rows(OutputFile& out, const std::filesystem::path& file, std::uint64_t bytes, bool with_header) {
  std::ifstream in(file, std::ios::binary);
  std::string header;
  std::getline(in, header);
  if (with_header) out.write(header + "\n");
  std::uint64_t left = bytes - std::min(bytes, std::uint64_t{header.size()} + 1);
  std::string piece(std::size_t{1} << 20, '\0');
  while (left > 0) {
    in.read(piece.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(left, piece.size())));
    if (in.gcount() == 0) {
      throw BadInput(Problem{.file = file.string(), .what = "cannot read this table", .why = "it ended early"});
    }
    out.write(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())));
    left -= static_cast<std::uint64_t>(in.gcount());
  }
}

/// Joins the tables under temporary names first: the result may replace one of its inputs, and an interrupted run
/// resumes with its `.part`.
void join_tables(const std::vector<Part>& parts, const std::filesystem::path& output) {
  const auto joined_name = [&](const TableMark& mark) { return output / (mark.file_name + ".joined"); };
  const std::vector<TableMark>& tables = parts.front().state.tables;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    OutputFile joined(joined_name(tables[k]));
    for (const Part& part : parts) {
      const TableMark& mark = part.state.tables[k];
      append_rows(joined, find_marked(part.folder, mark), mark.bytes, &part == &parts.front());
    }
    joined.commit();
  }
  for (const TableMark& mark : tables) rename_file(joined_name(mark), output / mark.file_name);
}

/// The results may be written to the folder of a single part, but not to that of one of several, whose tables they
/// would replace.
void check_output(const std::vector<Part>& parts, const std::filesystem::path& output) {
  std::error_code ignored;
  for (const Part& part : parts) {
    if (parts.size() == 1 || !std::filesystem::equivalent(part.folder, output, ignored)) continue;
    throw BadInput(Problem{.file = output.string(),
                           .what = "cannot write the results here",
                           .why = "it is the folder of one of the runs to merge",
                           .hint = "Choose another folder",
                           .option = "-o"});
  }
}

void merge_states(const std::vector<Part>& parts, RunSums& sums) {
  Problems problems;
  const auto observers = sums.observers();
  for (const Part& part : parts) {
    gather(problems, [&] {
      const std::uint64_t before = sums.summary().done;
      merge_run_state(part.file(), observers);
      if (const auto lacks = sums.lacking_memory()) throw OutOfMemory(*lacks + "; nothing is merged");
      if (sums.summary().done - before == part.state.rocks().count()) return;
      throw BadInput(Problem{.file = part.file().string(),
                             .what = "cannot use this state of a run",
                             .why = "its sums are of other rocks than its header declares"});
    });
  }
  throw_if_any(problems);
}

}  // namespace

MergeResult merge_runs(const MergeOptions& options) {
  std::vector<Part> parts = read_parts(options.folders);
  check_that_they_belong_together(parts);
  std::ranges::sort(parts, {}, [](const Part& part) { return std::pair(part.state.range, part.state.done); });
  check_that_none_is_double(parts);
  const std::vector<RockRange> missing = missing_rocks(parts);
  if (!options.partial) refuse_missing(parts, missing);
  check_tables(parts);

  const RunDescription& description = parts.front().state.description;
  std::filesystem::path output = options.output;
  if (output.empty() && options.folders.size() == 1) output = options.folders.front();
  if (output.empty()) output = description.name;
  check_output(parts, output);
  RunSums sums(description);
  sums.limit_maps_memory(options.maps_memory);
  merge_states(parts, sums);

  RunCourse course{.range = {0, description.rocks}, .interrupted = !missing.empty(), .missing = missing};
  for (const Part& part : parts) course.seconds += part.state.seconds;
  course.threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  make_output_folder(output);
  const FolderLock lock = lock_output_folder(output);
  remove_finished_summary(output);
  join_tables(parts, output);
  auto [warnings, trajectories] = write_results(output, description, sums, course);
  return {output, description, sums.summary(), std::move(warnings), missing, parts.size(), trajectories};
}

}  // namespace talus::project
