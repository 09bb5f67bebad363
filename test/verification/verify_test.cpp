#include "talus/verification/verify.hpp"
#include "support/places.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "talus/verification/cases.hpp"
#include "talus/verification/show.hpp"

namespace talus::verification {
namespace {

using testing::HasSubstr;

Files cases_of_the_repository() { return cases_in(talus::places::in_source("/verification")); }

CaseResult verified(const Files& files, const std::string& name) { return verify(read_case(files, name), files); }

void replace(std::string& text, std::string_view part, std::string_view with) {
  const std::size_t at = text.find(part);
  ASSERT_NE(at, std::string::npos) << part;
  text.replace(at, part.size(), with);
}

const Line* find_line(const CaseResult& result, std::string_view table, std::string_view row,
                      std::string_view quantity) {
  for (const TableResult& t : result.tables) {
    if (t.title != table) continue;
    for (const Line& line : t.lines) {
      if (line.row == row && line.quantity == quantity) return &line;
    }
  }
  return nullptr;
}

TEST(Verify, TheBowlsAgreeWithTheirTables) {
  const Files files = cases_of_the_repository();
  for (const std::string name : {"2-bowl-lumped-mass", "7-bowl-rigid-sphere"}) {
    const CaseResult result = verified(files, name);
    EXPECT_TRUE(result.passes()) << text(result);
    EXPECT_EQ(result.count(Verdict::agrees), 156u) << name;
    EXPECT_EQ(result.count(Verdict::left_out), 0u) << name;
  }
}

TEST(Verify, DetectsASingleWrongDigit) {
  Files files = cases_of_the_repository();
  replace(files["2-bowl-lumped-mass/table-2-4.csv"], "2.8631", "2.8634");
  const CaseResult result = verified(files, "2-bowl-lumped-mass");
  EXPECT_FALSE(result.passes());
  EXPECT_EQ(result.count(Verdict::differs), 1u);
  const Line* line = find_line(result, "Table 2-4, RocFall3", "3", "y_m");
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->verdict, Verdict::differs);
  EXPECT_EQ(line->published, "2.8634");
  EXPECT_NEAR(*line->difference, -0.0003, 1e-4);
}

TEST(Verify, DetectsAWrongGravity) {
  Files files = cases_of_the_repository();
  replace(files["2-bowl-lumped-mass/bowl.toml"], "gravity_m_s2 = 9.80665", "gravity_m_s2 = 9.81");
  const CaseResult result = verified(files, "2-bowl-lumped-mass");
  EXPECT_GT(result.tables[0].count(Verdict::differs), 40u);
  EXPECT_EQ(result.tables[1].count(Verdict::differs), 0u);
}

TEST(Verify, APathThatIsTooShortDiffers) {
  Files files = cases_of_the_repository();
  replace(files["7-bowl-rigid-sphere/bowl.toml"], "[analysis]", "[analysis]\nmax_time_s = 1");
  const CaseResult result = verified(files, "7-bowl-rigid-sphere");
  const Line* line = find_line(result, "Table 7-1, RocFall3", "5", "x_m");
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->verdict, Verdict::differs);
  EXPECT_FALSE(line->ours);
}

TEST(Verify, LeavesOutNumbersOnlyWithAReason) {
  const CaseResult result = verified(cases_of_the_repository(), "3-sliding");
  EXPECT_TRUE(result.passes()) << summary(std::array{result});
  for (const TableResult& table : result.tables) {
    EXPECT_FALSE(table.why.empty());
    for (const Line& line : table.lines) {
      EXPECT_FALSE(line.verdict == Verdict::left_out && line.why.empty()) << table.title << ' ' << line.row;
    }
  }
  const Line* misprint = find_line(result, "Table B-3, by hand, to the turn-back", "10", "pe");
  ASSERT_NE(misprint, nullptr);
  EXPECT_EQ(misprint->verdict, Verdict::left_out);
  EXPECT_EQ(misprint->published, "784532");
}

TEST(Verify, DetectsASeederThatWasNotRotated) {
  Files files = cases_of_the_repository();
  replace(files["5-rotation/case.toml"], "\"seeder.0.direction=[0.86602540378443871, 0.49999999999999994, 0]\"",
          "\"seeder.0.direction=[1, 0, 0]\"");
  const CaseResult result = verified(files, "5-rotation");
  const Line* line = find_line(result, "Runout, all directions", "30 degrees", "mean");
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->verdict, Verdict::differs);
  EXPECT_EQ(find_line(result, "Runout, all directions", "60 degrees", "mean")->verdict, Verdict::agrees);
}

TEST(Verify, DetectsAnEndReasonThatIsNotAllowed) {
  Files files = cases_of_the_repository();
  replace(files["6-rigid-body/case.toml"], "ends = [\"at rest\", \"left the model\"]", "ends = [\"at rest\"]");
  const CaseResult result = verified(files, "6-rigid-body");
  const Line* line = find_line(result, "Scenario 2, both restitutions side by side", "ended: left the model", "rocks");
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->verdict, Verdict::differs);
}

TEST(Verify, ComparesTheMotionOfABlockAtTheTimesOfATable) {
  Files files = cases_of_the_repository();
  replace(files["8-blocks/table-brick.csv"], "0.652517,15.0000,1.141718", "0.652517,15.1000,1.141718");
  const CaseResult result = verified(files, "8-blocks");
  EXPECT_EQ(find_line(result, "A brick tips", "3", "turned_deg")->verdict, Verdict::differs);
  EXPECT_EQ(find_line(result, "A brick tips", "3", "w_rad_s")->verdict, Verdict::agrees);
  EXPECT_EQ(find_line(result, "A cube strikes with a corner", "after", "wx_rad_s")->verdict, Verdict::agrees);
}

TEST(Show, TextHasEachNumberNextToThePublishedOne) {
  const CaseResult result = verified(cases_of_the_repository(), "2-bowl-lumped-mass");
  const std::string shown = text(result);
  EXPECT_THAT(shown, HasSubstr("Table 2-4, RocFall3 [g = 9.80665], section 2.4"));
  EXPECT_THAT(shown, testing::ContainsRegex("3 +y_m +2\\.8631 +2\\.863126 +\\+[0-9.e-]+ +0\\.0001 +agrees"));
  EXPECT_THAT(shown, HasSubstr("2-bowl-lumped-mass: 156 of 156 numbers agree"));
}

TEST(Show, SummaryShowsWhatDiffers) {
  Files files = cases_of_the_repository();
  replace(files["7-bowl-rigid-sphere/table-7-1.csv"], "3.4838", "3.4938");
  const CaseResult good = verified(files, "2-bowl-lumped-mass"), bad = verified(files, "7-bowl-rigid-sphere");
  const std::string shown = summary(std::array{good, bad});
  EXPECT_THAT(shown, HasSubstr("OUT: 7-bowl-rigid-sphere, Table 7-1, RocFall3 [g = 9.80665], section 7.4"));
  EXPECT_THAT(shown, HasSubstr("3.4938"));
  EXPECT_THAT(shown, HasSubstr("FAILS"));
  EXPECT_THAT(shown, testing::Not(HasSubstr("OUT: 2-bowl")));
}

TEST(Show, JsonHasEveryNumber) {
  const CaseResult result = verified(cases_of_the_repository(), "7-bowl-rigid-sphere");
  const nlohmann::ordered_json shown = json(std::array{result});
  EXPECT_EQ(shown["passes"], true);
  const auto& table = shown["cases"][0]["tables"][0];
  EXPECT_EQ(table["title"], "Table 7-1, RocFall3");
  EXPECT_EQ(table["numbers"].size(), 78u);
  EXPECT_EQ(table["numbers"][14]["published"], "3.0472");
  EXPECT_NEAR(table["numbers"][14]["talus"].get<double>(), 3.0472, 1e-4);
  EXPECT_EQ(table["numbers"][14]["verdict"], "agrees");
}

std::string document(const std::string& name) {
  std::ifstream stream(talus::places::in_source("/docs/" + name));
  EXPECT_TRUE(stream) << name;
  std::ostringstream whole;
  whole << stream.rdbuf();
  return whole.str();
}

// The numbers on the page require a run of all cases; this checks that its texts are those of the cases.
TEST(VerificationPage, IsNotStale) {
  const std::string page_text = document("verification-tables.md");
  EXPECT_TRUE(page_text.starts_with(page_title)) << "create it: talus verify --page docs/verification-tables.md";
  const Files files = cases_of_the_repository();
  for (const std::string& name : case_names(files)) {
    const Case c = read_case(files, name);
    EXPECT_THAT(page_text, HasSubstr(fmt::format("\n## {}: {}\n\n*{}.* {}\n", c.name, c.title, c.source, c.about)));
    for (const std::string& note : c.notes) EXPECT_THAT(page_text, HasSubstr("- " + note + "\n"));
    for (const Table& table : c.tables) EXPECT_THAT(page_text, HasSubstr(description(table)));
  }
  EXPECT_THAT(page_text, testing::Not(HasSubstr("DIFFERS")));
}

/// The row of a case in a table of the page, split into cells.
std::vector<std::string> cells_of(const std::string& page_text, const std::string& name) {
  std::vector<std::string> cells;
  const std::size_t begin = page_text.find("\n| " + name + " |");
  if (begin == std::string::npos) return cells;
  std::istringstream row(page_text.substr(begin + 3, page_text.find('\n', begin + 1) - begin - 3));
  for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
  return cells;
}

// Columns of the tables: agree, differ, left out; of the summary: agree, left out.
TEST(VerificationPage, SummaryHasTheCountsOfTheTables) {
  const std::string tables = document("verification-tables.md"), summary = document("verification.md");
  std::array<int, 2> all{};
  for (const std::string& name : case_names(cases_of_the_repository())) {
    const std::vector<std::string> there = cells_of(tables, name), here = cells_of(summary, name);
    ASSERT_EQ(there.size(), 6u) << name;
    ASSERT_EQ(here.size(), 4u) << name;
    EXPECT_EQ(here[2], there[3]) << name;
    EXPECT_EQ(there[4], " 0 ") << name;
    EXPECT_EQ(here[3], there[5]) << name;
    all[0] += std::stoi(there[3]);
    all[1] += std::stoi(there[5]);
  }
  EXPECT_THAT(summary, HasSubstr(fmt::format("\n| all | | {} | {} |\n", all[0], all[1])));
}

struct Outcome {
  int code;
  std::string text;
};
Outcome program(const std::string& arguments) {
  Outcome outcome{-1, {}};
  std::FILE* pipe = popen((std::string(talus::places::program) + " verify " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> part{};
  while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) outcome.text.append(part.data(), read);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

TEST(VerifyProgram, NeedsNoFiles) {
  const Outcome outcome = program("2 7");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("passes"));
}

TEST(VerifyProgram, ExitsWithTwoOnAnUnknownCase) {
  const Outcome outcome = program("8-nothing");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("there is no case \"8-nothing\""));
}

TEST(VerifyProgram, ExitsWithOneIfANumberDiffers) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "talus_verify_test";
  std::filesystem::create_directories(folder / "2-bowl");
  Files files = cases_of_the_repository();
  replace(files["2-bowl-lumped-mass/table-2-5.csv"], "14.0623", "14.0723");
  for (const std::string name : {"case.toml", "bowl.toml", "table-2-4.csv", "table-2-5.csv"}) {
    std::ofstream(folder / "2-bowl" / name) << files["2-bowl-lumped-mass/" + name];
  }
  const std::filesystem::path json_file = folder / "result.json";
  const Outcome outcome = program(fmt::format("--cases {} --json {}", folder.string(), json_file.string()));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.text, HasSubstr("OUT: 2-bowl, Table 2-5, by hand [g = 9.81], section 2.4"));
  std::ifstream stream(json_file);
  EXPECT_EQ(nlohmann::json::parse(stream)["passes"], false);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace talus::verification
