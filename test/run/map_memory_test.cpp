// The memory limit of maps.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/thread_ranks.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/run/merge.hpp"
#include "talus/run/run.hpp"
#include "talus/run/run_on_ranks.hpp"

namespace talus::project {
namespace {

using test::bytes_of;
using test::differences;
using test::files_of;
using test::Workplace;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

struct Loaded {
  Project project;
  Problems warnings;
  Model model;
};

/// The tutorial's slope with cells so small that its maps take some megabytes.
Loaded load(std::int64_t rocks, const std::string& setting = "output.report=false") {
  Reading reading =
      read_project(test::tutorial("3d"),
                   {{"output.raster_cell_m=0.1", "output.paths=\"none\"", "output.report=false", setting}, rocks, {}});
  Loaded loaded{std::move(reading.project), std::move(reading.warnings), {}};
  loaded.model = build_model(loaded.project, loaded.warnings);
  return loaded;
}

RunResult run(const Loaded& loaded, const std::filesystem::path& folder, const RunOptions& options) {
  return run_into(folder, loaded.project, loaded.model, loaded.warnings, options);
}

std::string why_not(const std::function<void()>& work) {
  try {
    work();
  } catch (const OutOfMemory& lack) {
    return lack.what();
  }
  return "";
}

struct Gathered {
  std::string saved;
  std::size_t taken = 0, most_taken = 0;  // after the last block, and after any
};

Gathered gather(const Loaded& loaded, std::size_t limit) {
  Gathered gathered;
  const auto maps = map_observer(loaded.project, loaded.model);
  if (limit > 0) maps->limit_memory(limit);
  Observer* const observers[] = {maps.get()};
  (void)run_campaign(loaded.model, observers, {.threads = 2, .progress = [&](std::uint64_t) {
                                                 gathered.most_taken =
                                                     std::max(gathered.most_taken, maps->memory_taken());
                                               }});
  ByteWriter out;
  maps->save(out);
  gathered.saved = out.take();
  gathered.taken = maps->memory_taken();
  return gathered;
}

// Without a limit 16 MB of visits are queued. With a limit just above the maps themselves fewer are, with the same
// bits.
TEST(MapMemory, IsKeptByQueueingFewerVisits) {
  for (const char* split : {"output.maps_by_source=false", "output.maps_by_source=true"}) {
    const Loaded loaded = load(20'000, split);
    const Gathered free = gather(loaded, 0);
    const std::size_t limit = free.taken + free.taken / 4;
    EXPECT_GT(free.most_taken, limit) << split;
    const Gathered limited = gather(loaded, limit);
    EXPECT_LE(limited.most_taken, limit) << split;
    EXPECT_TRUE(limited.saved == free.saved) << split;
  }
}

TEST(MapMemory, ThatIsExceededEndsTheRunAndKeepsTheRocksDone) {
  const Workplace work;
  const Loaded loaded = load(6000);
  RunOptions options{.campaign = {.threads = 2}};
  run(loaded, work / "whole", options);
  options.maps_memory = 2'000'000;
  const std::string lack =
      "not enough memory for the maps of this run: they take [0-9.]+ MB, and 2.0 MB is what they "
      "may \\(--maps-memory\\); ";
  const std::string hint =
      "\\. Maps take less with larger cells \\(output.raster_cell_m\\), fewer quantities \\(output.maps, "
      "output.bands\\) or no "
      "percentiles \\(output.percentiles = \\[\\]\\)";
  const std::string said = why_not([&] { run(loaded, work / "out", options); });
  EXPECT_THAT(
      said, MatchesRegex(
                lack + "the first [0-9]+ of 6000 rocks are kept: with --resume it continues from there, if given more" +
                hint));
  const std::string kept = said.substr(said.find("first"), said.find(" of 6000") - said.find("first"));
  options.resume = true;
  EXPECT_THAT(why_not([&] { run(loaded, work / "out", options); }), HasSubstr(kept)) << "still too little";
  options.maps_memory = 0;
  EXPECT_EQ(why_not([&] { run(loaded, work / "out", options); }), "");
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "out")), "");

  options.resume = false;
  options.maps_memory = 2'000'000;
  options.checkpoint_every = 0;
  EXPECT_THAT(why_not([&] { run(loaded, work / "none", options); }),
              MatchesRegex(lack + "none of its rocks are kept" + hint));
  EXPECT_EQ(why_not([&] {
              run(load(6000, "output.maps=false"), work / "none", options);
              run(load(6000, "output.raster_cell_m=4"), work / "none", options);
            }),
            "");
}

TEST(MapMemory, IsLimitedWhenShardsAreMerged) {
  const Workplace work;
  const Loaded loaded = load(3000);
  for (const std::uint64_t number : {1, 2}) run(loaded, work / std::to_string(number), {.shard = Shard{number, 2}});
  MergeOptions options{.folders = {work / "1", work / "2"}, .output = work / "merged", .maps_memory = 2'000'000};
  EXPECT_THAT(why_not([&] { merge_runs(options); }),
              MatchesRegex("not enough memory for the maps of this run: they take [0-9.]+ MB, and 2.0 MB is what they "
                           "may \\(--maps-memory\\); nothing is merged"));
  EXPECT_FALSE(std::filesystem::exists(work / "merged"));
  options.maps_memory = 0;
  EXPECT_EQ(why_not([&] { merge_runs(options); }), "");
}

// Each rank has maps of its own until they are gathered: first only the helper's are limited, then only rank 0's.
TEST(MapMemory, IsLimitedOnEachRank) {
  const Workplace work;
  const Loaded loaded = load(6000);
  for (const bool helper : {true, false}) {
    std::string said;
    testing_tools::with_ranks(
        2,
        [&](Ranks& mine) {
          try {
            RunOptions options{.campaign = {.threads = 1}, .ranks = &mine};
            if (!helper) options.maps_memory = 2'000'000;
            run(loaded, work / "out", options);
          } catch (const std::exception& error) {
            said = error.what();
          }
          dismiss_ranks(mine, 4);
        },
        [&](Ranks& mine) {
          RunOptions options;
          if (helper) options.maps_memory = 2'000'000;
          try {
            EXPECT_EQ(help_run(mine, loaded.project, loaded.model, loaded.warnings, options), 4);
          } catch (const std::exception& error) {
            EXPECT_EQ(cannot_help(mine, error.what(), 4), 4);
          }
        });
    EXPECT_THAT(said, HasSubstr("not enough memory for the maps of this run")) << helper;
    EXPECT_EQ(said.starts_with("rank 1 on machine 1: "), helper) << said;
  }
}

}  // namespace
}  // namespace talus::project
