#pragma once
// Reports of small runs, asked by scripts in a browser.

#include <string>
#include <vector>

#include "support/browser.hpp"
#include "support/sample_run.hpp"
#include "talus/report/report.hpp"

namespace talus {

/// A terrain of `side_m` metres a side around the rocks, which end within 10 m of the origin.
inline nlohmann::ordered_json on_terrain(double side_m) {
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

/// The result of `script` in the report of a run with this summary.
inline std::string said_of(const nlohmann::ordered_json& summary, const std::string& script) {
  const sample_run::Folder folder("report-said");
  sample_run::write(folder);
  folder.write("summary.json", summary.dump());
  write_report(std::vector{folder.path}, folder.path / "report.html");
  return testing_tools::said_in_page(folder.path / "report.html", script);
}

/// Rows of the table with this caption, cells separated by "|".
inline std::string rows_of(const std::string& caption) {
  return R"(
  const table = [...document.querySelectorAll('table')].find((t) => t.caption && t.caption.textContent.startsWith(')" +
         caption + R"('));
  const rows = [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent).join('|'));
)";
}

/// The print style on a page as wide as A4 between its margins; `mm` converts a length in pixels.
inline constexpr auto on_paper = R"(
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule.media) rule.media.mediaText = rule.media.mediaText === 'print' ? 'all' : 'not all';
  document.body.style.width = '184mm';
  const mm = (pixels) => pixels * 184 / document.body.getBoundingClientRect().width;
)";

}  // namespace talus
