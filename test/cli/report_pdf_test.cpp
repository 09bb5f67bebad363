// `talus report --pdf`: the sheet on paper, with the title block and maps at a true scale.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/program.hpp"
#include "support/browser.hpp"
#include "support/pictures.hpp"
#include "support/places.hpp"
#include "talus/files/sha256.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

bool has_poppler() { return std::system("command -v pdftotext >/dev/null 2>&1") == 0; }

constexpr const char* title_block = R"(
[report]
client = "Municipality of Bergheim"
project = "Road K12"
number = "2026-117"
author = "A. Meier"
checked = "B. Rossi"
revision = "B"
text = "For approval"
logo = "logo.png"
)";

class ReportPdf : public testing::Test {
 protected:
  /// Runs the tutorial with a title block in 2D or 3D.
  void run(const char* dimensions, const std::string& more = "") {
    std::ifstream in(tutorial(dimensions));
    project_ = std::string{std::istreambuf_iterator<char>(in), {}} + title_block + more;
    work.write("logo.png", testing_tools::small_png(60, 20));
    const Said said = talus_says("run " + work.write("slope.toml", project_) + " -q -o " + out());
    ASSERT_EQ(said.exit_code, 0) << said.text;
  }
  [[nodiscard]] std::string out() const { return (work / "out").string(); }
  [[nodiscard]] std::string pdf() const { return (work / "sheet.pdf").string(); }
  [[nodiscard]] Said printed(const std::string& options = "", const std::string& before = "") const {
    return talus_says("report " + out() + " --pdf " + pdf() + " " + options, before);
  }
  [[nodiscard]] std::string text_of_page(int page) const {
    const std::string number = std::to_string(page);
    return says("pdftotext -layout -f " + number + " -l " + number + " " + pdf() + " -").text;
  }
  [[nodiscard]] std::string fact(const std::string& name) const {
    return says("pdfinfo " + pdf() + " | sed -n 's/^" + name + ": *//p'").text;
  }
  /// Names in the working folder, to see what is left behind.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(work / "")) found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
  }

  const Workplace work;
  std::string project_;
};

/// Scales of the horizontal axes of a page: metres between the first and the last number of a line, by their distance
/// on paper.
std::vector<double> scales_on(const std::string& pdf, int page) {
  const std::string number = std::to_string(page);
  const std::string boxes = says("pdftotext -bbox -f " + number + " -l " + number + " " + pdf + " -").text;
  const std::regex word(R"re(xMin="([0-9.]+)" yMin="([0-9.]+)" xMax="([0-9.]+)" yMax="[0-9.]+">((?:−)?[0-9,]+)<)re");
  struct Label {
    double at_pt, value_m;
  };
  std::map<long, std::vector<Label>> lines;
  for (auto found = std::sregex_iterator(boxes.begin(), boxes.end(), word); found != std::sregex_iterator(); ++found) {
    std::string text = (*found)[4];
    const bool is_negative = text.starts_with("−");
    if (is_negative) text.erase(0, std::string_view("−").size());
    std::erase(text, ',');
    const double left = std::stod((*found)[1]), right = std::stod((*found)[3]);
    lines[std::lround(std::stod((*found)[2]))].push_back(
        {(left + right) / 2, (is_negative ? -1 : 1) * std::stod(text)});
  }
  std::vector<double> scales;
  for (const auto& [y, labels] : lines) {
    if (labels.size() < 3) continue;
    const double metres = labels.back().value_m - labels.front().value_m;
    scales.push_back(metres / ((labels.back().at_pt - labels.front().at_pt) / 72 * 0.0254));
  }
  return scales;
}

/// The scales that the sheet states.
std::vector<double> stated_scales(const std::string& text) {
  std::vector<double> scales;
  const std::regex scale("Scale 1:([0-9,]+) on");
  for (auto found = std::sregex_iterator(text.begin(), text.end(), scale); found != std::sregex_iterator(); ++found) {
    std::string digits = (*found)[1];
    std::erase(digits, ',');
    scales.push_back(std::stod(digits));
  }
  return scales;
}

TEST_F(ReportPdf, IsASheetWithItsTitleBlock) {
  if (!testing_tools::has_browser() || !has_poppler()) GTEST_SKIP() << "there is no chromium or no pdftotext";
  run("2d");
  const Said said = printed();
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_EQ(said.text, pdf() + "\n");
  EXPECT_THAT(fact("Page size"), HasSubstr("(A4)"));
  EXPECT_THAT(fact("Title"), HasSubstr("Tutorial 1"));
  const int pages = std::stoi(fact("Pages"));
  EXPECT_GT(pages, 2);
  const std::string first = text_of_page(1);
  for (const char* text : {"Municipality of Bergheim", "Road K12", "2026-117", "A. Meier", "B. Rossi", "For approval",
                           "Talus 0.1.0", "Section with trajectories"}) {
    EXPECT_THAT(first, HasSubstr(text));
  }
  for (int page = 1; page <= pages; ++page) {
    EXPECT_THAT(text_of_page(page), ContainsRegex(std::to_string(page) + " ?/ ?" + std::to_string(pages)));
    EXPECT_THAT(text_of_page(page), HasSubstr("Municipality of Bergheim · Road K12 · 2026-117 · Rev. B"));
  }
  EXPECT_THAT(names(), ElementsAre("logo.png", "out", "sheet.pdf", "slope.toml"));
  EXPECT_EQ(printed("--set \"report.author=C. Keller\"").exit_code, 0) << "it replaces its own file";
  EXPECT_THAT(text_of_page(1), HasSubstr("C. Keller"));
}

TEST_F(ReportPdf, HasTheScalesThatItStates) {
  if (!testing_tools::has_browser() || !has_poppler()) GTEST_SKIP() << "there is no chromium or no pdftotext";
  run("3d");
  for (const std::string paper : {"A4", "A3"}) {
    const Said said = printed("--paper " + paper);
    ASSERT_EQ(said.exit_code, 0) << said.text;
    EXPECT_THAT(fact("Page size"), HasSubstr("(" + paper + ")"));
    const std::vector<double> stated = stated_scales(text_of_page(1)), measured = scales_on(pdf(), 1);
    ASSERT_EQ(stated.size(), 2U) << text_of_page(1);  // plan and section
    for (const double scale : stated) {
      EXPECT_TRUE(std::ranges::any_of(measured, [&](double m) { return std::abs(m / scale - 1) < 0.003; }))
          << paper << " states 1:" << scale << ", measured " << ::testing::PrintToString(measured);
    }
  }
}

TEST_F(ReportPdf, ListsInputsThatSha256sumConfirms) {
  run("2d");
  const auto summary = nlohmann::json::parse(work.read("out/summary.json"));
  const auto& files = summary.at("inputs").at("files");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].at("name"), "slope.toml");
  EXPECT_EQ(files[0].at("bytes"), project_.size());
  EXPECT_EQ(files[0].at("sha256"), sha256_of(project_));
  EXPECT_EQ(files[1].at("name"), "logo.png");
  EXPECT_EQ(files[1].at("sha256"), sha256_of(work.read("logo.png")));
  EXPECT_TRUE(summary.at("inputs").at("logo").get<std::string>().starts_with("data:image/png;base64,"));
}

TEST_F(ReportPdf, AnotherTitleBlockIsNoOtherRun) {
  run("2d");
  std::string changed = project_;
  changed.replace(changed.find("A. Meier"), 8, "C. Keller");
  work.write("slope.toml", changed);
  const Said said = talus_says("run " + (work / "slope.toml").string() + " --resume -o " + out());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("complete"));
}

TEST_F(ReportPdf, NeedsABrowser) {
  run("2d");
  const Said none = printed("", "PATH=/nowhere CHROME= ");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.text,
            "--pdf: there is no browser to print the report with (neither Chromium nor Chrome is on the PATH). Install "
            "one (Debian: apt install chromium) or name it in the environment variable CHROME; or open report.html in "
            "any browser and print it to a file\n");
  const Said wrong = printed("", "CHROME=/not/there ");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(
      wrong.text,
      "--pdf: the environment variable CHROME is \"/not/there\" (there is no such program). Set it to the path of "
      "Chromium or Chrome, or unset it\n");
  EXPECT_THAT(names(), ElementsAre("logo.png", "out", "slope.toml"));
}

/// A program in the place of a browser.
std::string stand_in(const Workplace& work, const std::string& script) {
  const std::string file = work.write("browser", "#!/bin/sh\n" + script);
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

TEST_F(ReportPdf, ReportsABrowserThatFails) {
  run("2d");
  const std::string browser = stand_in(work, "echo starting; echo 'cannot open the display' >&2; exit 1\n");
  const Said said = printed("", "CHROME=" + browser + " ");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, "--pdf: " + browser +
                           " did not print the report (cannot open the display). Open report.html in a browser and "
                           "print it to a file\n");
  EXPECT_THAT(names(), ElementsAre("browser", "logo.png", "out", "slope.toml"));
}

TEST_F(ReportPdf, NamesAreNoCommandsAndAHalfPdfIsNone) {
  run("2d");
  const std::string browser = stand_in(work, R"(for word in "$@"; do
  case "$word" in --print-to-pdf=*) printf '%%PDF-1.4 cut' > "${word#--print-to-pdf=}";; esac
done
printf '%s\n' "$@" > )" + (work / "words").string() +
                                                 "\n");
  const std::string name = (work / "a; touch b & $(touch c).pdf").string();
  const Said said =
      says("CHROME=" + browser + " " + talus::places::program + " report " + out() + " --pdf '" + name + "'");
  EXPECT_EQ(said.exit_code, 2) << said.text;
  EXPECT_THAT(said.text, HasSubstr("did not print the report"));
  EXPECT_THAT(names(), ElementsAre("browser", "logo.png", "out", "slope.toml", "words"));
  const std::string words = work.read("words");
  EXPECT_THAT(words, HasSubstr("--host-resolver-rules=MAP * ~NOTFOUND\n"));
  EXPECT_THAT(words, HasSubstr("a%3B%20touch%20b%20%26%20%24%28touch%20c%29.pdf."));
}

TEST_F(ReportPdf, IsStoppedByCtrlC) {
  run("2d");
  const std::string browser = stand_in(work, "touch " + (work / "started").string() + "; sleep 600\n");
  setenv("CHROME", browser.c_str(), 1);
  Child child({"report", out(), "--pdf", pdf()}, work / "said");
  unsetenv("CHROME");
  ASSERT_TRUE(appears(work / "started"));
  const auto begin = std::chrono::steady_clock::now();
  child.signal(SIGINT);
  EXPECT_EQ(child.wait(), 3);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(1));
  EXPECT_THAT(names(), ElementsAre("browser", "logo.png", "out", "said", "slope.toml", "started"));
}

TEST_F(ReportPdf, DoesNotReplaceOtherFiles) {
  run("2d");
  work.write("sheet.pdf", "my notes");
  const Said said = printed();
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, pdf() +
                           ": this file already exists (it is not a PDF file written by this command, and only "
                           "those are replaced). Choose another name\n");
  EXPECT_EQ(work.read("sheet.pdf"), "my notes");
}

TEST_F(ReportPdf, OverridesOfOtherTablesAreRefused) {
  run("2d");
  EXPECT_EQ(talus_says("report " + out() + " --set sampling.seed=2").exit_code, 2);
  const Said said = talus_says("report " + out() + " --set \"report.checked=D. Huber\"");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(work.read("out/report.html"), HasSubstr("D. Huber"));
}

TEST_F(ReportPdf, UnitsOtherThanTheTwoAreRefused) {
  run("2d");
  const std::string before = work.read("out/report.html");
  const Said said = talus_says("report " + out() + " --units imperial");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text,
            "--set report.units=imperial: [report]: units is \"imperial\" (expected \"metric\" or \"us\")\n");
  EXPECT_EQ(work.read("out/report.html"), before);
  EXPECT_EQ(talus_says("report " + out() + " --units us").exit_code, 0);
  EXPECT_THAT(work.read("out/report.html"), HasSubstr("\"units\":\"us\""));
}

}  // namespace
}  // namespace talus::test
