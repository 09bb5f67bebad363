// The report as a browser draws it.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/sample_run.hpp"
#include "support/browser.hpp"
#include "talus/io/report.hpp"

namespace talus::io {
namespace {

using testing_tools::has_browser;
using testing_tools::said_in_page;

/// A terrain of so many metres a side around the rocks, which end within 10 m of the origin.
nlohmann::ordered_json on_terrain(double side_m) {
  constexpr int nodes = 20;
  auto heights = nlohmann::ordered_json::array();
  for (int k = 0; k < nodes * nodes; ++k) heights.push_back(100 - 2 * (k % nodes));
  auto summary = sample_run::summary("Terrain");
  const double half = side_m / 2, cell = side_m / nodes;
  summary["terrain"] = {{"kind", "raster"},
                        {"bounds", {{-half, -half, 60}, {half, half, 100}}},
                        {"relief",
                         {{"x0", -half + cell / 2},
                          {"y0", -half + cell / 2},
                          {"cell_m", cell},
                          {"columns", nodes},
                          {"rows", nodes},
                          {"z_m", heights}}}};
  return summary;
}

/// The greatest x on the plan's axis, a click on the plan's switch if there is one, and the greatest x then.
const std::string greatest_x_before_and_after = R"(
  const svg = document.querySelector('svg[aria-label^="Plan of the terrain"]');
  const greatest = () => Math.max(...[...svg.querySelector('.axis').querySelectorAll('text')].map((t) => +t.textContent.replace('−', '-').replace(',', '')));
  const button = svg.parentNode.querySelector('.zoom button');
  if (!button) return greatest() + ' no switch';
  const texts = [greatest(), button.textContent];
  button.click();
  return [...texts, greatest(), button.textContent].join(' ');
)";

std::string plan_of(double side_m) {
  const sample_run::Folder folder("report-plan");
  sample_run::write(folder);
  folder.write("summary.json", on_terrain(side_m).dump());
  write_report(std::vector{folder.path}, folder.path / "report.html");
  return said_in_page(folder.path / "report.html", greatest_x_before_and_after);
}

TEST(ReportInBrowser, PlanOpensOnTheRocksWhereTheyFillLittleOfTheTerrain) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(plan_of(1000), "5.5 Show the whole terrain 500 Show the rocks");
}

TEST(ReportInBrowser, PlanShowsTheTerrainWhereRocksFillIt) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(plan_of(5), "5 no switch");
}

TEST(ReportInBrowser, SaysWhatTheRunWarnedOfAndNoted) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  const sample_run::Folder folder("report-notes");
  sample_run::write(folder);
  auto summary = sample_run::summary("Notes");
  summary["warnings"] = {"warning: rocks: 2 of 2 rocks were ended at the maximum time"};
  summary["notes"] = {"2 of 2 rocks left the model"};
  folder.write("summary.json", summary.dump());
  write_report(std::vector{folder.path}, folder.path / "report.html");
  EXPECT_EQ(said_in_page(folder.path / "report.html",
                         "return [...document.querySelectorAll('.note li')].slice(0, 2).map((li) => "
                         "li.textContent).join('; ');"),
            "warning: rocks: 2 of 2 rocks were ended at the maximum time; 2 of 2 rocks left the model");
}

}  // namespace
}  // namespace talus::io
