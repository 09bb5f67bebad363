#include "talus/verification/case.hpp"
#include "support/places.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "talus/core/problems.hpp"
#include "talus/project/read.hpp"
#include "talus/verification/cases.hpp"

namespace talus::verification {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Files repository_cases() { return cases_in(talus::places::in_source("/verification")); }

constexpr std::string_view good_case = R"(
title = "A case"
source = "section 1"
about = "Of something."
[[run]]
name = "plain"
project = "a.toml"
[[table]]
kind = "path"
title = "Table"
source = "section 1"
why = "Because."
runs = ["plain"]
published = "t.csv"
columns = { x_m = "x", y_m = "z" }
tolerance = { units = 1 }
[[table.exception]]
rows = ["1"]
columns = ["y_m"]
why = "A misprint."
)";

Files files_with(std::string case_text) {
  return {{"a/a.toml", ""}, {"a/case.toml", std::move(case_text)}, {"a/t.csv", "id,x_m,y_m\n0,1.5,2\n1,2.5,3\n"}};
}

/// The good case with one part replaced.
std::string replaced(std::string_view part, std::string_view with) {
  std::string text(good_case);
  text.replace(text.find(part), part.size(), with);
  return text;
}

std::string message(const std::string& case_text) {
  try {
    static_cast<void>(read_case(files_with(case_text), "a"));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "accepted";
}

TEST(Case, IsReadCompletely) {
  const Case c = read_case(files_with(std::string(good_case)), "a");
  EXPECT_EQ(c.title, "A case");
  ASSERT_EQ(c.tables.size(), 1u);
  const auto& table = std::get<PathTable>(c.tables[0].kind);
  ASSERT_EQ(table.columns.size(), 2u);
  EXPECT_EQ(table.columns[1].second, PathQuantity::z);
  EXPECT_THAT(table.events, ElementsAre(0, 1));
  ASSERT_EQ(table.exceptions.size(), 1u);
  EXPECT_FALSE(table.exceptions[0].tolerance);
  EXPECT_TRUE(table.exceptions[0].concerns("1", "y_m"));
  EXPECT_FALSE(table.exceptions[0].concerns("1", "x_m"));
  EXPECT_FALSE(table.exceptions[0].concerns("0", "y_m"));
}

TEST(Case, RefusesUnknownKeysAndWords) {
  EXPECT_THAT(message(replaced("tolerance = {", "tolerances = {")),
              HasSubstr("a/case.toml:16: table: there is no key tolerances"));
  EXPECT_THAT(message(replaced("tolerance = {", "tolerances = {")), HasSubstr("Did you mean tolerance?"));
  EXPECT_THAT(message(replaced("\"path\"", "\"paths\"")), HasSubstr("kind is \"paths\" (expected one of path,"));
  EXPECT_THAT(message(replaced("\"z\"", "\"height\"")), HasSubstr("y_m is \"height\" (expected one of time,"));
  EXPECT_THAT(message(replaced("y_m = \"z\"", "w_m = \"z\"")),
              HasSubstr("a/t.csv has no column w_m (its columns are x_m, y_m)"));
  EXPECT_THAT(message(replaced("rows = [\"1\"]", "rows = [\"7\"]")),
              HasSubstr("a/t.csv has no row 7 (its rows are 0, 1)"));
  EXPECT_THAT(message(replaced("runs = [\"plain\"]", "runs = [\"plan\"]")),
              HasSubstr("there is no run \"plan\" (the runs are plain). Did you mean plain?"));
  EXPECT_THAT(message(replaced("\"a.toml\"", "\"b.toml\"")), HasSubstr("there is no file b.toml"));
  EXPECT_THAT(message(replaced("\"t.csv\"", "\"u.csv\"")), HasSubstr("a/u.csv: there is no such file"));
  EXPECT_THAT(message(replaced("units = 1", "units = -1")), HasSubstr("units is -1 (expected a number, not negative)"));
}

TEST(Case, WholeNumbersBeyondDoublePrecisionAreRounded) {
  const std::string huge = replaced("units = 1", "units = 9007199254740993");
  const Case c = read_case(files_with(huge), "a");
  EXPECT_EQ(std::get<PathTable>(c.tables[0].kind).tolerance.units, 9007199254740992.0);
}

TEST(Case, RequiresAReasonAndATitle) {
  EXPECT_THAT(message(replaced("why = \"A misprint.\"", "")), HasSubstr("exception: why is missing"));
  EXPECT_THAT(message(replaced("why = \"Because.\"", "")), HasSubstr("table: why is missing"));
  EXPECT_THAT(message(replaced("title = \"A case\"", "")), HasSubstr("title is missing"));
}

TEST(Case, MayCompareAtTheTimesOfAColumn) {
  const auto with_times = [](std::string_view column) {
    return replaced("tolerance = { units = 1 }", fmt::format("tolerance = {{ units = 1 }}\ntimes = \"{}\"", column));
  };
  const Case c = read_case(files_with(with_times("x_m")), "a");
  EXPECT_EQ(std::get<PathTable>(c.tables[0].kind).times, 0u);
  EXPECT_TRUE(std::get<PathTable>(c.tables[0].kind).events.empty());
  EXPECT_THAT(message(with_times("t_s")), HasSubstr("a/t.csv has no column t_s"));
  Files files = files_with(with_times("x_m"));
  files["a/t.csv"] = "id,x_m,y_m\n0,1.5,2\n1,-,3\n";
  EXPECT_THROW(static_cast<void>(read_case(files, "a")), BadInput);
}

TEST(Case, StatisticsNeedManyRocks) {
  Files files = files_with(R"(
title = "A case"
source = "section 1"
about = "Of something."
run = [{ name = "few", project = "a.toml", rocks = 5000 }]
[[table]]
kind = "statistics"
title = "Table"
source = "section 1"
why = "Because."
runs = ["few"]
published = "s.csv"
columns = ["one"]
sample = "end_x_m"
tested = ["mean"]
)");
  files["a/s.csv"] = "statistic,one\nmean,5\ncount,50\n";
  try {
    static_cast<void>(read_case(files, "a"));
    FAIL() << "accepted";
  } catch (const BadInput& bad) {
    EXPECT_THAT(bad.what(), HasSubstr("run \"few\" has 5000 rocks (the spread of samples needs many more rocks than "
                                      "the samples have). Give the run rocks = 20000 or more"));
  }
}

TEST(ChosenCases, AreSelectedByNameOrBeginning) {
  const Files files{{"1-one/case.toml", ""}, {"1-other/case.toml", ""}, {"2-two/case.toml", ""}, {"2-two/t.csv", ""}};
  EXPECT_THAT(chosen_cases(files, {}), ElementsAre("1-one", "1-other", "2-two"));
  EXPECT_THAT(chosen_cases(files, {"2"}), ElementsAre("2-two"));
  EXPECT_THAT(chosen_cases(files, {"2-two", "1-other", "1"}), ElementsAre("1-one", "1-other", "2-two"));
}

TEST(ChosenCases, RefuseAnUnknownName) {
  const Files files{{"1-one/case.toml", ""}, {"2-two/case.toml", ""}};
  try {
    static_cast<void>(chosen_cases(files, {"2-tow"}));
    FAIL() << "accepted";
  } catch (const BadInput& bad) {
    EXPECT_STREQ(bad.what(), "verify: there is no case \"2-tow\" (the cases are 1-one, 2-two). Did you mean 2-two?");
  }
}

TEST(CasesIn, RefusesAFolderWithoutCases) {
  const std::string folder = talus::places::in_source("/cmake");
  try {
    static_cast<void>(cases_in(folder));
    FAIL() << "accepted";
  } catch (const BadInput& bad) {
    EXPECT_THAT(
        bad.what(),
        HasSubstr("there is no case in it (expected a folder with one folder per case, each with a case.toml)"));
  }
  EXPECT_THROW(static_cast<void>(cases_in(folder + "/nowhere")), BadInput);
}

TEST(RepositoryCases, AreEightAndBuiltIn) {
  const Files files = repository_cases();
  EXPECT_EQ(case_names(files).size(), 8u);
  EXPECT_EQ(embedded_cases(), files);
}

TEST(RepositoryCases, UseEveryFileOfTheirFolders) {
  const Files files = repository_cases();
  std::set<std::string> used;
  for (const std::string& name : case_names(files)) {
    const Case c = read_case(files, name);
    used.insert(name + "/case.toml");
    for (const verification::Run& run : c.runs) used.insert(fmt::format("{}/{}", name, run.project));
    for (const Table& table : c.tables) {
      if (const auto* path = std::get_if<PathTable>(&table.kind)) used.insert(path->published.file());
      if (const auto* statistics = std::get_if<StatisticsTable>(&table.kind)) used.insert(statistics->published.file());
    }
  }
  for (const auto& [path, text] : files) EXPECT_TRUE(used.contains(path)) << path << " is not used";
}

TEST(RepositoryCases, CompareEveryColumnOfEveryPath) {
  const Files files = repository_cases();
  for (const std::string& name : case_names(files)) {
    for (const Table& table : read_case(files, name).tables) {
      const auto* path = std::get_if<PathTable>(&table.kind);
      if (path == nullptr) continue;
      for (std::size_t c = 0; c < path->published.columns().size(); ++c) {
        const std::string& column = path->published.columns()[c];
        const bool is_compared = std::ranges::find(path->columns, column,
                                                   &std::pair<std::string, PathQuantity>::first) != path->columns.end();
        const bool is_word = column == "state" || column == "type";
        // B-2 and B-3 also print the time since the previous row, which follows from their times.
        const bool is_given_twice = column == "dt_s" && table.title.starts_with("Table B-");
        EXPECT_TRUE(is_compared || is_word || is_given_twice || path->times == c)
            << table.title << ", column " << column;
      }
    }
  }
}

TEST(RepositoryCases, RotateTheSeederWithTheTerrain) {
  const Files files = repository_cases();
  const Case c = read_case(files, "5-rotation");
  ASSERT_EQ(c.runs.size(), 12u);
  for (std::size_t k = 0; k < c.runs.size(); ++k) {
    const verification::Run& run = c.runs[k];
    const double degrees = 30.0 * static_cast<double>(k);
    const double cosine = std::cos(degrees * std::numbers::pi / 180), sine = std::sin(degrees * std::numbers::pi / 180);
    const project::Project p =
        project::read_project_text(files.at("5-rotation/" + run.project), run.project, {run.settings, {}, {}}).project;
    EXPECT_EQ(run.name, fmt::format("{} degrees", degrees));
    EXPECT_EQ(p.terrain.rotate_deg, degrees);
    ASSERT_EQ(p.seeders.size(), 1u);
    const std::array<Vec3, 2> ends{Vec3(0.5, -25, 0), Vec3(0.5, 25, 0)};  // from the axis at (0, 25, 0)
    ASSERT_EQ(p.seeders[0].at_points.points.size(), 2u);
    for (std::size_t e = 0; e < 2; ++e) {
      const Vec3 expected = turned(ends[e], cosine, sine) + Vec3(0, 25, 0);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(p.seeders[0].at_points.points[e][static_cast<std::size_t>(axis)], expected[axis], 1e-13)
            << run.name;
      }
    }
    EXPECT_NEAR(p.seeders[0].direction->at(0), cosine, 1e-15);
    EXPECT_NEAR(p.seeders[0].direction->at(1), sine, 1e-15);
  }
}

}  // namespace
}  // namespace talus::verification
