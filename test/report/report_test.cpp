#include "talus/report/report.hpp"
#include "support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "support/file_size_limit.hpp"
#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"
#include "talus/report/page/assets.hpp"

namespace talus {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string page_of(const sample_run::Folder& folder) {
  const std::vector<RunFolder> runs{read_run_folder(folder.path)};
  return report_page(runs);
}

// The data that the page's script reads.
nlohmann::ordered_json data_in(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(open) + open.size();
  return nlohmann::ordered_json::parse(page.substr(from, page.find("</script>", from) - from));
}

void collect_numbers(const nlohmann::ordered_json& node, std::vector<std::string>& numbers) {
  if (node.is_number()) numbers.push_back(node.dump());
  if (node.is_structured()) {
    for (const auto& child : node) collect_numbers(child, numbers);
  }
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string message(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& html) {
  try {
    write_report(folders, html);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "no message";
}

TEST(Report, LoadsNothingExternal) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  const std::string page = page_of(folder);
  const std::regex loads(R"((src|href|data)\s*=\s*["']?\s*(https?:|//|file:))", std::regex::icase);
  const std::string own = std::string(assets::page) + std::string(assets::style) + std::string(assets::report_script) +
                          std::string(assets::sensitivity_script) + std::string(assets::models_script);
  for (const std::string& text : {page, own}) {
    EXPECT_FALSE(std::regex_search(text, loads));
    for (const char* part : {"<link", "<iframe", "<script src", "@import", "url(http", "url(//"}) {
      EXPECT_THAT(text, Not(HasSubstr(part)));
    }
  }
  for (const char* part : {"fetch(", "XMLHttpRequest", "WebSocket", "sendBeacon", "import("})
    EXPECT_THAT(own, Not(HasSubstr(part)));
  // The content security policy enforces this, whatever a script in the page tries.
  EXPECT_THAT(
      page,
      HasSubstr("default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:"));
}

TEST(Report, IsOneCompletePage) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  const std::string page = page_of(folder);
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_THAT(page, HasSubstr("<title>Tutorial 1 · Talus rockfall report</title>"));
  EXPECT_THAT(page, Not(HasSubstr("{{style}}")));
  EXPECT_EQ(count_of(page, "</script>"), 2u);  // data, and the page with D3
  EXPECT_THAT(std::string(assets::report_script), HasSubstr("D3 (https://d3js.org), copyright"));
}

TEST(Report, HasEveryNumberOfTheSummary) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  const auto shown = data_in(page_of(folder)).at("runs").at(0).at("summary");
  EXPECT_EQ(shown, sample_run::summary("Tutorial 1"));
  std::vector<std::string> numbers;
  collect_numbers(sample_run::summary("Tutorial 1"), numbers);
  ASSERT_GT(numbers.size(), 80u);
  const std::string page = page_of(folder);
  for (const std::string& number : numbers) EXPECT_THAT(page, HasSubstr(number));
}

TEST(Report, HasPathsEndPointsHitsAndLosses) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  const auto run = data_in(page_of(folder)).at("runs").at(0);
  EXPECT_EQ(run.at("paths").at("total"), 2);
  EXPECT_EQ(run.at("paths").at("rocks").at(1).at("rows").at(1).dump(),
            R"(["impact",1.577,3.1,0.0,-12.2,1.5,0.0,-15.47,120766.1,0.0,0.0])");
  EXPECT_EQ(run.at("endpoints").at("rows").at(1).dump(),
            R"([1,"seeder 1",5.25,0.0,-12.2,4.75,13.01,2.25,"at rest",120000.0,1.5])");
  EXPECT_EQ(run.at("hits").at("rows").at(0).dump(),
            R"(["Fence",1,1.9,4.5,0.0,-11.45,0.75,12.5,54000.0,60766.1,"stopped"])");
  EXPECT_EQ(run.at("losses").at("rows").dump(), "[[0,1,3.1,2.6,60000.0,120766.1],[1,1,3.1,2.6,60000.0,120766.1]]");
  EXPECT_EQ(run.at("losses").at("by_number").dump(), "[[1,2,60000.0,60000.0,60000.0]]");
}

TEST(Report, KeepsCoordinatesOfLargeMapsToATenthOfAMillimetre) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  folder.write("paths.csv",
               sample_run::paths_head + "0,0,ended,0,2600123.45678,1200000.12345,1.00004,0,0,0,0,0,0,0,0,0\n");
  const auto row = data_in(page_of(folder)).at("runs").at(0).at("paths").at("rocks").at(0).at("rows").at(0);
  EXPECT_EQ(row.dump(), R"(["ended",0.0,2600123.4568,1200000.1235,1.0,0.0,0.0,0.0,0.0,0.0,0.0])");
}

TEST(Report, ShowsNamesAsTextAndNeverAsMarkup) {
  const std::string name = "</script><script>alert(1)</script><b>\"&'<!--";
  const sample_run::Folder folder("report");
  sample_run::write(folder, name);
  auto summary = sample_run::summary(name);
  summary["barriers"][0]["name"] = name;
  summary["project"]["material"][0]["name"] = name;
  summary["warnings"] = {name};
  folder.write("summary.json", summary.dump());
  const std::string page = page_of(folder);
  EXPECT_THAT(
      page, HasSubstr("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;&lt;b&gt;&quot;&amp;&#39;&lt;!-- ·"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(count_of(page, "</script>"), 2u);
  EXPECT_EQ(data_in(page).at("runs").at(0).at("summary").at("barriers").at(0).at("name"), name);
  // The page's scripts and the figures set text and attributes only; the bundle also has D3's own functions.
  std::string scripts;
  for (const char* source : {"/web/src/report", "/web/src/figures"}) {
    for (const auto& file : std::filesystem::directory_iterator(talus::places::in_source(source))) {
      std::ifstream in(file.path());
      if (file.path().extension() == ".ts") scripts += std::string(std::istreambuf_iterator<char>(in), {});
    }
  }
  EXPECT_THAT(scripts, HasSubstr("export function histogram("));
  EXPECT_THAT(scripts, HasSubstr("function barrierSections("));
  for (const char* part : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", ".html(", "eval("}) {
    EXPECT_THAT(scripts, Not(HasSubstr(part)));
  }
}

TEST(Report, AcceptsNamesThatAreNotUtf8OrLookLikePlaceholders) {
  const sample_run::Folder folder("report");
  sample_run::write(folder, "{{script}}");
  folder.write("barriers.csv", sample_run::barriers_head +
                                   "Fence \xff,1,1.9,4.5,0,-11.45,0.75,3,0,0,12.5,54000,6766,60766,stopped,,1.641\n");
  const std::string page = page_of(folder);
  EXPECT_THAT(page, HasSubstr("<title>{{script}} ·"));
  EXPECT_EQ(data_in(page).at("runs").at(0).at("hits").at("rows").at(0).at(0), "Fence \xEF\xBF\xBD");
}

TEST(Report, ComparesTwoRuns) {
  const sample_run::Folder first("report-first"), second("report-second"), out("report-out");
  sample_run::write(first, "In section");
  sample_run::write(second, "Extruded");
  const auto html = out.path / "report.html";
  write_report(std::vector{first.path, second.path}, html);
  const std::string page = out.read("report.html");
  EXPECT_THAT(page, HasSubstr("<title>In section and Extruded · Talus rockfall report</title>"));
  const auto runs = data_in(page).at("runs");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs.at(0).at("summary").at("name"), "In section");
  EXPECT_EQ(runs.at(1).at("summary").at("name"), "Extruded");
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("paths").at("rocks").size(), 2u);
    EXPECT_EQ(run.at("endpoints").at("rows").size(), 2u);
  }
}

TEST(Report, CountsTwoRunsInTheSameBins) {
  using Json = nlohmann::ordered_json;
  const sample_run::Folder first("report-first"), second("report-second"), out("report-out");
  const auto write = [](const sample_run::Folder& folder, const Json& runout, const Json& energy) {
    sample_run::write(folder);
    auto summary = sample_run::summary("Run");
    summary["histograms"]["runout_xy_m"] = runout;
    summary["barriers"][0]["histograms"]["ke_translational_J"] = energy;
    folder.write("summary.json", summary.dump());
  };
  const Json fine{{"low", 6.0}, {"width", 2.0}, {"counts", {1, 2, 3, 4, 5}}};  // to 16
  const Json coarse{{"low", 0.0}, {"width", 5.0}, {"counts", {7, 8, 9, 1}}};   // to 20
  write(first, fine, coarse);
  write(second, coarse, fine);
  write_report(std::vector{first.path, second.path}, out.path / "report.html");
  const auto runs = data_in(out.read("report.html")).at("runs");
  const Json both[]{{{"low", 0.0}, {"width", 10.0}, {"counts", {3, 12}}},
                    {{"low", 0.0}, {"width", 10.0}, {"counts", {15, 10}}}};
  for (const std::size_t k : {0u, 1u}) {
    const auto& summary = runs.at(k).at("summary");
    EXPECT_EQ(summary.at("histograms").at("runout_xy_m").dump(), both[k].dump());
    EXPECT_EQ(summary.at("barriers").at(0).at("histograms").at("ke_translational_J").dump(), both[1 - k].dump());
  }
  // A single run keeps its own bins.
  const auto alone = data_in(page_of(first)).at("runs").at(0).at("summary");
  EXPECT_EQ(alone.at("histograms").at("runout_xy_m").dump(), fine.dump());
}

TEST(Report, OfManyRocksIsReproducibleAndWithinItsLimits) {
  const sample_run::Folder folder("report");
  auto summary = sample_run::summary("many");
  summary["rocks"]["done"] = summary["rocks"]["with_endpoint"] = 3000;
  folder.write("summary.json", summary.dump());
  std::string endpoints = sample_run::endpoints_head, paths = sample_run::paths_head;
  for (std::uint64_t rock = 0; rock < 3000; ++rock) {
    endpoints += sample_run::endpoint_row(rock);
    paths += sample_run::path_rows(rock);
  }
  folder.write("endpoints.csv", endpoints);
  folder.write("paths.csv", paths);
  const std::string page = page_of(folder);
  const auto run = data_in(page).at("runs").at(0);
  EXPECT_EQ(run.at("paths").at("rocks").size(), Limits{}.paths);
  EXPECT_EQ(run.at("paths").at("total"), 3000);
  EXPECT_EQ(run.at("endpoints").at("rows").size(), Limits{}.endpoints);
  EXPECT_EQ(run.at("endpoints").at("total"), 3000);
  EXPECT_EQ(run.at("losses").at("by_number").at(0).at(1), 3000);  // not of the shown rocks only
  EXPECT_EQ(page_of(folder), page);
}

TEST(Report, IsCompleteOrAbsent) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  const auto html = folder.path / "report.html";
  write_report(std::vector{folder.path}, html);
  EXPECT_EQ(folder.read("report.html"), page_of(folder));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "report.html.part"));
}

TEST(ReportRefuses, AnyOtherNumberOfRuns) {
  EXPECT_EQ(message({}, "report.html"), "report: given 0 run folders (a report shows one run, or two for comparison)");
  EXPECT_EQ(message({"a", "b", "c"}, "report.html"),
            "report: given 3 run folders (a report shows one run, or two for comparison)");
}

TEST(ReportRefuses, ProblemsOfBothFoldersAtOnce) {
  EXPECT_EQ(
      message({"absent-1", "absent-2"}, "report.html"),
      "absent-1: there is no such folder (expected the folder of a run). Name a folder that `talus run` has written\n"
      "absent-2: there is no such folder (expected the folder of a run). Name a folder that `talus run` has written");
}

TEST(ReportRefuses, UnwritablePlaces) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  const auto html = folder.path / "absent" / "report.html";
  EXPECT_EQ(message({folder.path}, html),
            html.string() + ": cannot create this file (No such file or directory). Choose another folder with -o");
  std::filesystem::create_directories(folder.path / "taken.html" / "inside");
  EXPECT_EQ(message({folder.path}, folder.path / "taken.html"),
            (folder.path / "taken.html").string() +
                ": cannot write this file (it is a folder). Name an ordinary file, or one that does not exist yet");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "taken.html.part"));
}

TEST(ReportRefuses, AFullDisk) {
  const sample_run::Folder folder("report");
  sample_run::write(folder);
  folder.write("report.html", "the report of before");
  const testing_tools::FileSizeLimit limit(65536);
  EXPECT_EQ(
      message({folder.path}, folder.path / "report.html"),
      (folder.path / "report.html").string() +
          ": cannot write to this file (File too large). Allow larger files (ulimit -f), or write elsewhere with -o");
  EXPECT_EQ(folder.read("report.html"), "the report of before");
}

}  // namespace
}  // namespace talus
