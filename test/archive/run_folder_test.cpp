#include "talus/archive/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/sample_run.hpp"
#include "talus/archive/spread_sample.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The message about the folder, with its path replaced.
std::string message(const std::filesystem::path& folder) {
  try {
    static_cast<void>(read_run_folder(folder));
  } catch (const BadInput& bad) {
    std::string text = bad.what();
    const std::string path = folder.string();
    for (std::size_t at = 0; (at = text.find(path, at)) != std::string::npos;) text.replace(at, path.size(), "DIR");
    return text;
  }
  return "no message";
}

// The message about a valid folder in which one file has this text.
std::string message_about(const std::string& file, const std::string& text) {
  const sample_run::Folder folder("run-folder");
  sample_run::write(folder);
  folder.write(file, text);
  return message(folder.path);
}

std::string message_about_summary(const char* pointer, const nlohmann::ordered_json& value) {
  auto summary = sample_run::summary("Tutorial 1");
  summary[nlohmann::ordered_json::json_pointer(pointer)] = value;
  return message_about("summary.json", summary.dump());
}

constexpr auto name_a_run = ". Name a folder that `talus run` has written";
constexpr auto damaged = ". The file was cut short or damaged; run the project again to write it anew";

TEST(RunFolder, ReadsWhatARunWrites) {
  const sample_run::Folder folder("run-folder");
  sample_run::write(folder);
  const RunFolder run = read_run_folder(folder.path);
  EXPECT_EQ(json_of(run.summary), sample_run::summary("Tutorial 1"));
  EXPECT_THAT(run.date, ::testing::MatchesRegex("[0-9]+-[0-9]+-[0-9]+ [0-9]+:[0-9]+ UTC"));
  EXPECT_THAT(run.notes, IsEmpty());

  ASSERT_EQ(run.endpoints.items.size(), 2u);
  EXPECT_EQ(run.endpoints.total, 2u);
  EXPECT_EQ(run.endpoints.items[1].rock, 1u);
  EXPECT_EQ(run.endpoints.items[1].seeder, "seeder 1");
  EXPECT_EQ(run.endpoints.items[1].end_reason, EndReason::at_rest);
  EXPECT_THAT(run.endpoints.items[1].position_m, ElementsAre(5.25, 0, -12.2));
  EXPECT_EQ(run.endpoints.items[1].max_ke_J, 120000);

  ASSERT_EQ(run.paths.items.size(), 2u);
  const Path& path = run.paths.items[0];
  ASSERT_EQ(path.rows.size(), 4u);
  EXPECT_EQ(path.rows[1].state, PathState::impact);
  EXPECT_EQ(path.rows[1].time_s, 1.577);
  EXPECT_THAT(path.rows[1].velocity_m_s, ElementsAre(1.5, 0, -15.47));
  EXPECT_EQ(path.rows[2].total_J(), 60766.13);

  ASSERT_EQ(run.hits.items.size(), 1u);
  EXPECT_EQ(run.hits.items[0].barrier, "Fence");
  EXPECT_EQ(run.hits.items[0].impact_height_m, 0.75);
  EXPECT_EQ(run.hits.items[0].outcome, BarrierOutcome::stopped);
}

TEST(RunFolder, AddsUpTheLossOfEachImpactOverAllRocks) {
  const sample_run::Folder folder("run-folder");
  sample_run::write(folder);
  // A third rock that loses 10 kJ and then 2.5 kJ, whose path is not kept.
  folder.write("paths.csv",
               sample_run::paths_head + sample_run::path_rows(0) + sample_run::path_rows(1) +
                   "2,0,impact,0,0,0,0,0,0,0,0,0,0,20000,0,5000\n2,1,projectile,0,0,0,0,0,0,0,0,0,0,9000,1000,5000\n"
                   "2,2,impact,1,0,0,0,0,0,0,0,0,0,14000,1000,0\n2,3,sliding,1,0,0,0,0,0,0,0,0,0,12500,0,0\n"
                   "2,4,ended,1,0,0,0,0,0,0,0,0,0,0,0,0\n");
  const RunFolder run = read_run_folder(folder.path, {.paths = 1});
  ASSERT_EQ(run.impact_losses.size(), 2u);
  EXPECT_EQ(run.impact_losses[0].count, 3u);
  EXPECT_NEAR(run.impact_losses[0].sum_J, 60000 + 60000 + 10000, 1e-6);
  EXPECT_NEAR(run.impact_losses[0].least_J, 10000, 1e-6);
  EXPECT_NEAR(run.impact_losses[0].most_J, 60000, 1e-6);
  EXPECT_EQ(run.impact_losses[1].count, 1u);
  EXPECT_NEAR(run.impact_losses[1].sum_J, 2500, 1e-6);
  EXPECT_EQ(run.paths.items.size(), 1u);
  EXPECT_EQ(run.paths.total, 3u);
}

TEST(RunFolder, NotesMissingTables) {
  const sample_run::Folder folder("run-folder");
  folder.write("summary.json", sample_run::summary("bare").dump());
  const RunFolder run = read_run_folder(folder.path);
  EXPECT_THAT(run.notes,
              ElementsAre("There is no endpoints.csv, so no single end points are shown.",
                          "There is no paths.csv, so no paths, energies along a path or losses at impacts are shown.",
                          "There is no barriers.csv, so no single hits on barriers are shown."));
}

TEST(RunFolder, ReadsNamesWithCommasQuotesAndLineEnds) {
  const sample_run::Folder folder("run-folder");
  sample_run::write(folder);
  folder.write(
      "barriers.csv",
      sample_run::barriers_head +
          "\"Fence \"\"A\"\", upper\n\nrow\",1,1.9,4.5,0,-11.45,0.75,3,0,0,12.5,54000,6766,60766,\"stopped\",,1.641\r\n"
          "\"\",1,2,4.5,0,-11.45,0.75,3,0,0,12.5,54000,6766,60766,passed,,1.641\n");
  const RunFolder run = read_run_folder(folder.path);
  ASSERT_EQ(run.hits.items.size(), 2u);
  EXPECT_EQ(run.hits.items[0].barrier, "Fence \"A\", upper\n\nrow");
  EXPECT_EQ(run.hits.items[0].outcome, BarrierOutcome::stopped);
  EXPECT_EQ(run.hits.items[1].barrier, "");
}

TEST(RunFolder, ShortensLongListsOfTheProject) {
  const sample_run::Folder folder("run-folder");
  auto summary = sample_run::summary("Tutorial 1");
  summary["project"]["terrain"]["vertices"] = std::vector<int>(5000, 1);
  folder.write("summary.json", summary.dump());
  EXPECT_EQ(read_run_folder(folder.path).summary.project->at("terrain").at("vertices"), "5000 entries");
}

// ---- refused folders

TEST(RunFolder, KeepsTheBarriersWithTheMostHits) {
  const sample_run::Folder folder("run-folder");
  sample_run::write(folder);
  auto summary = sample_run::summary("Tutorial 1");
  auto& barriers = summary["barriers"] = nlohmann::ordered_json::array();
  for (int k = 0; k < 1000; ++k) {
    auto barrier = sample_run::summary("")["barriers"][0];
    barrier["name"] = "c" + std::to_string(k);
    barrier["hits"] = k % 10 == 3 ? k : 0;
    barriers.push_back(std::move(barrier));
  }
  folder.write("summary.json", summary.dump());
  const RunFolder run = read_run_folder(folder.path);
  const auto& kept = run.summary.barriers;
  ASSERT_EQ(kept.size(), 100U);
  for (std::size_t k = 0; k < kept.size(); ++k) EXPECT_EQ(kept[k].hits, 10 * k + 3);
  EXPECT_THAT(run.notes, ElementsAre("Of 1000 barriers and collectors the 100 with the most hits are shown one by one; "
                                     "summary.json has all of them."));
}

TEST(RunFolderRefuses, PathsThatAreNotAFolder) {
  const sample_run::Folder folder("run-folder");
  EXPECT_EQ(message(folder.path / "absent"),
            "DIR: there is no such folder (expected the folder of a run). Name a folder that `talus run` has written");
  folder.write("file", "");
  EXPECT_EQ(message(folder.path / "file"),
            "DIR: is not a folder (expected the folder of a run). Name a folder that `talus run` has written");
  EXPECT_EQ(message(folder.path),
            "DIR/summary.json: there is no such file (the folder of a finished run has it). Name a folder that "
            "`talus run` has written");
}

TEST(RunFolderRefuses, SummariesThatAreNotJson) {
  EXPECT_EQ(message_about("summary.json", "{\n\"name\": \"Tut"),
            std::string("DIR/summary.json:2: the JSON ends too early (after 14 bytes)") + damaged);
  EXPECT_EQ(message_about("summary.json", "{\n\n\"name\": nonsense}"),
            std::string("DIR/summary.json:3: is not JSON (at byte 13)") + damaged);
  EXPECT_EQ(message_about("summary.json", ""),
            std::string("DIR/summary.json:1: the JSON ends too early (after 0 bytes)") + damaged);
  EXPECT_EQ(message_about("summary.json", "[1, 2]"),
            std::string("DIR/summary.json: is of type array (expected an object)") + name_a_run);
}

TEST(RunFolderRefuses, SummariesOfAnotherShape) {
  const auto refused = [](const char* pointer, const nlohmann::ordered_json& value, const std::string& expected) {
    EXPECT_EQ(message_about_summary(pointer, value), "DIR/summary.json: " + expected + name_a_run);
  };
  refused("/rocks", 50, "rocks: is of type number (expected an object)");
  refused("/warnings", nullptr, "warnings: is of type null (expected a list)");
  refused("/warnings/0", 7, "warnings/0: is of type number (expected a text)");
  refused("/rocks/done", "2", "rocks/done: is of type string (expected a whole number, 0 or more)");
  refused("/interrupted", 0, "interrupted: is of type number (expected true or false)");
  refused("/project", "none", "project: is of type string (expected an object)");
  refused("/statistics/end_x_m", 1, "statistics/end_x_m: is of type number (expected an object)");
  refused("/statistics/end_x_m/quartiles", {1, 2}, "statistics/end_x_m/quartiles: has 2 entries (expected 3)");
  refused("/barriers/0/name", 1, "barriers/0/name: is of type number (expected a text)");
  refused("/histograms/end_x_m/width", 0, "histograms/end_x_m: is not a histogram (expected a width above 0)");
  refused("/barriers/0/histograms/ke_translational_J/counts", "many",
          "barriers/0/histograms/ke_translational_J/counts: is of type string (expected a list)");
  refused("/terrain/section/1", nlohmann::ordered_json::array({1, 2, 3}),
          "terrain/section/1: has 3 entries (expected 2)");
  refused("/terrain/section", nlohmann::ordered_json::array({{1, 2}}),
          "terrain: has a section that is not a line (expected two or more vertices [x, z])");
  const nlohmann::ordered_json relief{{"x0", 0},      {"y0", 0},   {"cell_m", 1},
                                      {"columns", 2}, {"rows", 2}, {"z_m", {1, 2, 3}}};
  refused("/terrain/relief", relief,
          "terrain/relief: is not a grid (expected a cell_m above 0 and columns times rows heights z_m, 2 x 2)");
  refused("/terrain/relief", nlohmann::ordered_json{{"x0", 0}}, "terrain/relief/y0: is missing (a run writes it)");
}

// A run writes all keys: a file without one is damaged or of something else.
TEST(RunFolderRefuses, SummariesWithoutAKey) {
  const auto whole = sample_run::summary("Tutorial 1");
  for (const auto& [key, value] : whole.items()) {
    if (key == "inputs" || key == "releases") continue;  // of the first process only; earlier runs lack the releases
    auto summary = whole;
    summary.erase(key);
    EXPECT_EQ(message_about("summary.json", summary.dump()),
              "DIR/summary.json: " + key + ": is missing (a run writes it)" + name_a_run);
  }
}

TEST(RunFolderRefuses, TablesWithOtherColumns) {
  EXPECT_EQ(
      message_about("endpoints.csv", "rock,x,y\n"),
      "DIR/endpoints.csv:1: the columns are \"rock,x,y\" (expected \"rock,seeder,x_m,y_m,z_m,runout_xy_m,runout_z_m,"
      "runout_total_m,lateral_m,time_s,events,end_reason,ground,mass_kg,radius_m,max_ke_J,max_bounce_m,ensemble\")");
  EXPECT_EQ(message_about("paths.csv", ""),
            std::string("DIR/paths.csv:1: the file is empty (its first line must name the columns)") + damaged);
}

TEST(RunFolderRefuses, IncompleteRows) {
  EXPECT_EQ(message_about("endpoints.csv", sample_run::endpoints_head + sample_run::endpoint_row(0) + "1,seeder 1,3\n"),
            std::string("DIR/endpoints.csv:3: the row has 3 values (expected 18, one for each column)") + damaged);
  EXPECT_EQ(message_about("barriers.csv", sample_run::barriers_head + "\"Fence,1,1.9\n"),
            std::string("DIR/barriers.csv:2: a quoted value has no end (the file ends inside it)") + damaged);
}

TEST(RunFolderRefuses, ValuesThatAreNotNumbers) {
  const auto row = [](const std::string& rock, const std::string& x) {
    return sample_run::endpoints_head + rock + ",seeder 1," + x +
           ",0,-12.2,4.5,12.2,13.01,,2.25,4,at rest,Type One,1000,0.4455,120000,1.5,\n";
  };
  EXPECT_EQ(message_about("endpoints.csv", row("0", "5.1m")),
            "DIR/endpoints.csv:2: x_m: \"5.1m\" is not a number (expected a finite number)");
  EXPECT_EQ(message_about("endpoints.csv", row("0", "nan")),
            "DIR/endpoints.csv:2: x_m: \"nan\" is not a number (expected a finite number)");
  EXPECT_EQ(message_about("endpoints.csv", row("0", "")),
            "DIR/endpoints.csv:2: x_m: \"\" is not a number (expected a finite number)");
  EXPECT_EQ(message_about("endpoints.csv", row("-1", "5")),
            "DIR/endpoints.csv:2: rock: \"-1\" is not a count (expected a whole number, 0 or more)");
}

TEST(RunFolderRefuses, TruncatedTables) {
  const std::string paths = sample_run::paths_head + sample_run::path_rows(0) + sample_run::path_rows(1);
  // Inside a line.
  EXPECT_EQ(message_about("paths.csv", paths.substr(0, paths.size() - 1)),
            std::string("DIR/paths.csv:9: the last line has no line end (every row ends with one)") + damaged);
  EXPECT_EQ(message_about("paths.csv", paths.substr(0, paths.size() - 60)),
            std::string("DIR/paths.csv:8: the last line has no line end (every row ends with one)") + damaged);
  // Between two lines.
  const std::string short_paths = paths.substr(0, paths.find("1,3,ended"));
  EXPECT_EQ(
      message_about("paths.csv", short_paths),
      std::string("DIR/paths.csv: the path of rock 1 does not end (a path's last row has the state ended)") + damaged);
  EXPECT_EQ(
      message_about("endpoints.csv", sample_run::endpoints_head + sample_run::endpoint_row(0)),
      "DIR/endpoints.csv: has 1 rock (summary.json next to it counts 2). The files are of different runs, or one was "
      "cut short; run the project again");
}

TEST(RunFolder, AcceptsASampleOfTheEndPoints) {
  const sample_run::Folder folder("sample");
  sample_run::write(folder);
  folder.write("endpoints.csv", sample_run::endpoints_head + sample_run::endpoint_row(0));
  auto summary = sample_run::summary("Tutorial 1");
  summary["rocks"]["with_endpoint"] = 1;
  folder.write("summary.json", summary.dump());
  EXPECT_EQ(read_run_folder(folder.path).endpoints.total, 1u);
}

TEST(RunFolderRefuses, InvalidPaths) {
  std::string paths = sample_run::paths_head + sample_run::path_rows(0);
  paths.replace(paths.find("sliding"), 7, "flying");
  EXPECT_EQ(message_about("paths.csv", paths),
            "DIR/paths.csv:4: state: \"flying\" is not a state (expected one of projectile, impact, sliding, rolling, "
            "barrier, "
            "ended)");
  std::string mixed = sample_run::paths_head + sample_run::path_rows(7);
  mixed.replace(mixed.find("7,2,sliding"), 1, "8");
  EXPECT_EQ(message_about("paths.csv", mixed),
            "DIR/paths.csv:4: rock 8 begins before rock 7 has ended (a path's last row has the state ended). The file "
            "was cut or "
            "joined by hand; run the project again");
}

TEST(RunFolderRefuses, AllBadFilesAtOnce) {
  const sample_run::Folder folder("run-folder");
  sample_run::write(folder);
  folder.write("summary.json", "[]");
  folder.write("endpoints.csv", "rock\n");
  folder.write("paths.csv", "");
  const std::string text = message(folder.path);
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
  EXPECT_THAT(text, ::testing::AllOf(::testing::HasSubstr("summary.json"), ::testing::HasSubstr("endpoints.csv"),
                                     ::testing::HasSubstr("paths.csv")));
}

// ---- sampling

TEST(RunFolder, KeepsTheSameRocksInAnyOrder) {
  constexpr std::uint64_t rocks = 20000;
  std::vector<std::string> rows;
  for (std::uint64_t rock = 0; rock < rocks; ++rock)
    rows.push_back(sample_run::endpoint_row(rock, static_cast<double>(rock)));
  const auto kept = [&] {
    const sample_run::Folder folder("run-folder");
    std::string text = sample_run::endpoints_head;
    for (const std::string& row : rows) text += row;
    folder.write("endpoints.csv", text);
    auto summary = sample_run::summary("many");
    summary["rocks"]["with_endpoint"] = rocks;
    folder.write("summary.json", summary.dump());
    const RunFolder run = read_run_folder(folder.path);
    EXPECT_EQ(run.endpoints.total, rocks);
    std::vector<std::uint64_t> numbers;
    for (const EndpointRow& end : run.endpoints.items) {
      EXPECT_EQ(end.position_m[0], static_cast<double>(end.rock));
      numbers.push_back(end.rock);
    }
    return numbers;
  };
  const auto forwards = kept();
  EXPECT_EQ(forwards.size(), Limits{}.endpoints);
  EXPECT_TRUE(std::ranges::is_sorted(forwards));
  std::ranges::reverse(rows);
  EXPECT_EQ(kept(), forwards);
}

TEST(SpreadSample, TakesItsShareOfEveryRangeOfRocks) {
  constexpr std::uint64_t rocks = 1'000'000, stretch = 50'000;
  SpreadSample<std::uint64_t> sample(300, 1'000'000);
  for (std::uint64_t rock = 0; rock < rocks; ++rock) sample.add(rock, 1, rock);
  const auto kept = sample.take();
  ASSERT_EQ(kept.size(), 300u);
  EXPECT_EQ(kept.front(), 0u);
  for (std::uint64_t first = 0; first < rocks; first += stretch) {  // 15 expected in each
    const auto count =
        std::ranges::count_if(kept, [&](std::uint64_t rock) { return rock >= first && rock < first + stretch; });
    EXPECT_GE(count, 13) << "from rock " << first;
    EXPECT_LE(count, 17) << "from rock " << first;
  }
}

TEST(SpreadSample, StaysWithinItsWeightInAnyOrder) {
  const auto kept = [](bool reversed) {
    SpreadSample<std::uint64_t> sample(100, 500);
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const std::uint64_t rock = reversed ? 999 - i : i;
      sample.add(rock, 1 + rock % 37 * (rock % 3), rock);
    }
    return sample.take();
  };
  const auto forwards = kept(false);
  EXPECT_EQ(kept(true), forwards);
  std::uint64_t weight = 0;
  for (const std::uint64_t rock : forwards) weight += 1 + rock % 37 * (rock % 3);
  EXPECT_LE(weight, 500u);
  EXPECT_GT(weight, 400u);
}

TEST(SpreadSample, KeepsOneItemEvenIfItIsTooHeavy) {
  SpreadSample<int> sample(10, 5);
  sample.add(0, 50, 7);
  EXPECT_THAT(sample.take(), ElementsAre(7));
}

TEST(SpreadSample, KeepsItemsOfOneRockTogether) {
  SpreadSample<std::string> sample(3, 100);
  for (const std::uint64_t rock : {5, 0, 1}) {
    sample.add(rock, 1, std::to_string(rock) + "a");
    sample.add(rock, 1, std::to_string(rock) + "b");
  }
  EXPECT_THAT(sample.take(), ElementsAre("0a", "0b"));
}

}  // namespace
}  // namespace talus
