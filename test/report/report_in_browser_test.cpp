// The report in a browser.

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "report/report_in_browser.hpp"
#include "support/browser.hpp"
#include "support/sample_run.hpp"
#include "support/sample_run_3d.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/report/report.hpp"

namespace talus {
namespace {

using testing_tools::has_browser;
using testing_tools::said_in_page;

/// The maximum x on the plan's axis, before and after a click on the plan's switch if there is one.
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

TEST(ReportInBrowser, PlanOpensOnTheRocksIfTheyCoverLittleOfTheTerrain) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(plan_of(1000), "6 Show the whole terrain 400 Show the rocks");
}

TEST(ReportInBrowser, PlanShowsTheTerrainIfRocksCoverIt) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(plan_of(5), "5 no switch");
}

TEST(ReportInBrowser, ShowsWarningsAndNotesWithoutTheNameOfTheProjectFile) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = sample_run::summary("Notes");
  summary["warnings"] = {"warning: rocks: 2 of 2 rocks were ended at the maximum time",
                         "a/road.toml:31: warning: [ground]: 5 cells are in no polygon"};
  summary["notes"] = {"2 of 2 rocks left the model"};
  EXPECT_EQ(said_of(summary,
                    "return document.querySelector('.note h4').textContent + ': ' + "
                    "[...document.querySelectorAll('.note li')].slice(0, 3).map((li) => li.textContent).join('; ');"),
            "Warnings and notes: rocks: 2 of 2 rocks were ended at the maximum time; "
            "[ground]: 5 cells are in no polygon; 2 of 2 rocks left the model");
}

TEST(ReportInBrowser, DrawsEnvelopesAsStepsWithGapsWithoutRocks) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  const sample_run::Folder folder("report-envelopes");
  sample_run::write(folder);
  auto summary = sample_run::summary("Envelopes");
  summary["project"]["barrier"] = {{{"name", "Fence"}, {"line", {2.5, 0}}, {"height_m", 3}}};
  folder.write("summary.json", summary.dump());
  folder.write("envelopes.csv",
               "x_m,energy_total_max_kJ,energy_total_mean_kJ,energy_total_p95_kJ,energy_total_p99.5_kJ\n"
               "0.5,4,1,2,3\n1.5,8,1,2,3\n2.5,,,,\n3.5,2,1,1.5,1.5\n");
  write_report(std::vector{folder.path}, folder.path / "report.html");
  const std::string said = said_in_page(folder.path / "report.html", R"(
    const svg = document.querySelector('svg[aria-label^="Total kinetic energy along the section"]');
    const curve = svg.querySelector('path.envelope').getAttribute('d');
    const box = svg.querySelector('.under-pointer').getBoundingClientRect();  // of x from -0.08 to 4.08
    const clientX = box.left + box.width * (1.6 + 0.08) / 4.16;
    svg.querySelector('.under-pointer').dispatchEvent(new MouseEvent('mousemove', {bubbles: true, clientX}));
    return [curve.replace(/[-0-9., ]+/g, ''), svg.querySelectorAll('path.envelope').length,
            [...svg.querySelectorAll('text')].map((t) => t.textContent).filter((t) => /[a-z]/.test(t)).join('|'),
            document.getElementById('tip').textContent].join(' ; ');)");
  EXPECT_EQ(said,
            "MHVHMH ; 4 ; maximum|percentile 99.5|percentile 95|mean|x [m]|Total kinetic energy [kJ]|Fence ; "
            "x 1 to 2 m\nmaximum 8 kJ\npercentile 99.5 3 kJ\npercentile 95 2 kJ\nmean 1 kJ");
}

/// A line of a design with the same wide numbers everywhere.
nlohmann::ordered_json design_line(const std::string& name) {
  using Json = nlohmann::ordered_json;
  const Json range{1'234'567.8, 1'123'456.7, 1'345'678.9};
  const Json percentiles{{"50", range}, {"95", range}, {"99", range}};
  const Json quantities{{"ke_translational_J", percentiles}, {"velocity_m_s", percentiles}, {"height_m", percentiles}};
  const Json share{{"value", 0.12345}, {"low", 0.11234}, {"high", 0.13456}};
  const Json needs{{"energy_J", 2.5e6}, {"class", 6}, {"height_m", 8.35}};
  const Json worst{{"energy_J", 3.5e6}, {"class", 7}, {"height_m", 9.5}};
  const auto section = [&](double from_m, const Json& asks) {
    return Json{{"from_m", from_m},          {"to_m", from_m + 20}, {"rocks", 500},         {"share", share},
                {"percentiles", quantities}, {"needs", asks},       {"clearance_m", 23.456}};
  };
  return {{"name", name},
          {"length_m", 437.18971},
          {"rocks", 16348},
          {"share", share},
          {"percentiles", quantities},
          {"needs", needs},
          {"needs_at_upper_end", needs},
          {"clearance_m", 23.456},
          {"most_elongation_m", 18.043},
          {"sections", Json::array({section(0, needs), section(20, worst)})}};
}

/// A summary with every table of the report, all of them long.
nlohmann::ordered_json wide_summary() {
  using Json = nlohmann::ordered_json;
  auto summary = on_terrain(1000);
  Json& project = summary["project"];
  const Json drawn{
      {"mean", 1234.5}, {"distribution", "lognormal"}, {"std_dev", 0.65}, {"rel_min", 0.8}, {"rel_max", 4}};
  project["material"] = Json::array();
  project["seeder"] = Json::array();
  for (int k = 0; k < 7; ++k) {
    const std::string number = std::to_string(k);
    project["material"].push_back({{"name", "Material of the slope " + number},
                                   {"like", "talus_with_vegetation"},
                                   {"normal_restitution", drawn},
                                   {"tangential_restitution", drawn},
                                   {"friction_angle_deg", drawn},
                                   {"roughness_deg", drawn},
                                   {"forest", "medium"},
                                   {"forest_height_m", 10 + k}});
    Json seeder{{"name", "Faces_" + number}, {"polygons", "releases/of_the_whole_cliff.gpkg"}};
    for (const char* key : {"volume_m3", "density_kg_m3", "horizontal_velocity_m_s", "vertical_velocity_m_s",
                            "rotational_velocity_deg_s"}) {
      seeder[key] = drawn;
    }
    seeder["direction"] = {0, 1, 0};
    seeder["type"] = "polygon";
    project["seeder"].push_back(seeder);
  }
  const Json share{{"value", 0.962}, {"low", 0.929}, {"high", 0.983}};
  const Json kit{{"line", "Upper of the two lines"},
                 {"height_m", 5},
                 {"energy_J", 1.5e6},
                 {"class", 4},
                 {"suffices", true},
                 {"sure", false},
                 {"caught_share", share},
                 {"above", 12345},
                 {"through", 12345},
                 {"beside", 12345},
                 {"cost", 93068.3},
                 {"kit", "A net of 1500 kJ of a maker"},
                 {"needs_clearance_m", 12.345},
                 {"clearance_m", 23.456},
                 {"residual_height_m", 2.55},
                 {"below_residual_share", share}};
  const Json of_pair{
      {"line", "Upper of the two lines"}, {"kit", "A net of 1500 kJ of a maker"}, {"height_m", 5}, {"energy_J", 1.5e6}};
  const Json pair{
      {"first", of_pair},    {"second", of_pair},          {"suffices", true},        {"sure", false},
      {"rocks", 123456},     {"caught", 123456},           {"caught_share", share},   {"caught_by_first", 123456},
      {"at_second", 123456}, {"caught_by_second", 123456}, {"beside", 12345},         {"cost", 193068.3},
      {"overlap_m", -12.34}, {"distance_m", 45.67},        {"needs_overlap_m", 23.45}};
  const std::string long_text =
      "A. Author and B. Author, A publication about the design of barriers, Journal of Rockfall 6 (2014), 123-145";
  summary["design"] = {{"standard", "UNI 11211-4"},
                       {"factors", {{"of_total_energy", false}, {"level", "MEL"}, {"clearance_m", 0.5}}},
                       {"applied_factors", Json::array({{{"symbol", "γ_VolF1"},
                                                         {"key", "action_height_factor"},
                                                         {"multiplies", "velocity, height"},
                                                         {"value", 1.1},
                                                         {"source", long_text},
                                                         {"not_read", long_text}}})},
                       {"standard_not_read", long_text},
                       {"free_end_m", 5},
                       {"pairs", Json::array({pair, pair})},
                       {"design_percentile", 95},
                       {"confidence", 0.95},
                       {"catch_share", 0.95},
                       {"lines", Json::array({design_line("Upper"), design_line("Lower")})},
                       {"best", kit},
                       {"ranking", Json::array({kit, kit})}};
  return summary;
}

// The print style is applied to a page as wide as A4 between its margins.
constexpr auto tables_beyond_the_paper = R"(
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule.media && rule.media.mediaText === 'print') rule.media.mediaText = 'all';
  document.body.style.width = '184mm';
  const tables = [...document.querySelectorAll('table')];
  const end = (node) => node.getBoundingClientRect().right;
  const beyond = tables.filter((t) => end(t) > end(document.body) + 0.5);
  return (tables.length > 12) + ' ' + beyond.map((t) => t.caption && t.caption.textContent).join();
)";

TEST(ReportInBrowser, PrintsCompleteTables) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(wide_summary(), tables_beyond_the_paper), "true ");
}

TEST(ReportInBrowser, FitsTheWidthOfTheScreen) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(wide_summary(), "return document.documentElement.scrollWidth <= innerWidth;"), "true");
}

TEST(ReportInBrowser, HasAColumnForEachSeederWithManySettings) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(wide_summary(), rows_of("Seeders") + "return rows[0] + '; ' + rows[1] + '; ' + rows[7];"),
            "|Faces_0|Faces_1|Faces_2|Faces_3; Polygons|releases/of_the_whole_cliff.gpkg|releases/of_the_whole_cliff."
            "gpkg|releases/of_the_whole_cliff.gpkg|releases/of_the_whole_cliff.gpkg; Direction|0, 1, 0|0, 1, 0|0, 1, "
            "0|0, 1, 0");
}

TEST(ReportInBrowser, ShowsTheClassOfTheWorstSection) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(wide_summary(),
                    rows_of("Requirements of the check of UNI 11211-4, by translational energy") + "return rows[2];"),
            "Upper|2,500|6|8.35|2,500|6|8.35|3,500|7|9.5");
}

TEST(ReportInBrowser, NamesEveryKineticEnergyAsTotalOrTranslational) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(wide_summary(), R"(
    const texts = [...document.querySelectorAll('main *')].filter((e) => !e.children.length).map((e) => e.textContent);
    const named = texts.filter((text) => /kinetic energy/i.test(text));
    const unclear = named.filter((text) => /(?<!total |translational )kinetic energy/i.test(text));
    return (named.length > 5) + ' ' + unclear.join('; ');
  )"),
            "true ");
}

TEST(ReportInBrowser, DescribesTheAnalysis) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = on_terrain(1000);
  summary["terrain"]["bounds"] = {{2600000, 1200000, 1052.15}, {2602190, 1202580, 2206.972}};
  summary["energy_datum_m"] = 1000;
  summary["terrain"]["triangles"] = 2 * 438 * 516;
  summary["terrain"]["crs_wkt"] =
      R"(PROJCRS["MGI / Austria Lambert",BASEGEOGCRS["MGI",ID["EPSG",4312]],USAGE[AREA["Austria."]],ID["EPSG",31287]])";
  summary["project"]["terrain"] = {
      {"raster", "kot_5m.tif"}, {"merge_tolerance_m", 0.001}, {"rotate_deg", 0}, {"rotate_about", {0, 0, 0}}};
  summary["project"]["ground"] = {{"default", "Type One"},
                                  {"polygons", "ground_of_kot.gpkg"},
                                  {"attribute", "unit"},
                                  {"values", {{"Fels", "Type One"}, {"Wald", "Type_Two"}}}};
  EXPECT_EQ(said_of(summary, rows_of("Terrain") + "return rows.join('; ');"),
            "Kind|Elevation raster, 3D; Raster|kot_5m.tif; Coordinate system|MGI / Austria Lambert (EPSG:31287); "
            "Extent in x|2,600,000 to 2,602,190 m (2,190 m); Extent in y|1,200,000 to 1,202,580 m (2,580 m); "
            "Extent in z|1,052.15 to 2,206.972 m (1,154.8 m); Nodes|439 × 517; Cell size [m]|5; Triangles|452,016; "
            "Potential energy is zero at z|1,000 m");
  EXPECT_EQ(said_of(summary, rows_of("Ground") + "return rows.join('; ');"),
            "Default|Type One; Polygons|ground_of_kot.gpkg; Attribute of the material|unit; unit = Fels|Type One; "
            "unit = Wald|Type_Two");
}

TEST(ReportInBrowser, ShowsHighPercentilesOfEndPointsAndHits) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = sample_run::summary("Percentiles");
  summary["statistics"]["runout_xy_m"]["percentiles"] = {{"95", 28.25}, {"99", 28.375}};
  summary["barriers"][0]["statistics"]["ke_translational_J"]["percentiles"] = {{"95", 99'500}, {"99", 99'900}};
  const std::string high = "return rows.filter((row) => row.startsWith('Percentile')).join('; ');";
  EXPECT_EQ(said_of(summary, rows_of("Descriptive statistics, one value per rock") + high),
            "Percentile 95|–|28.25|–; Percentile 99|–|28.38|–");
  EXPECT_EQ(said_of(summary, rows_of("Descriptive statistics of the hits") + high),
            "Percentile 95|99.5; Percentile 99|99.9");
}

TEST(ReportInBrowser, ExplainsRocksThatPassAboveAndNegativeClearances) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = sample_run::summary("Above");
  summary["barriers"][0]["least_clearance_m"] = -0.449;
  EXPECT_EQ(
      said_of(summary, "return [...document.querySelectorAll('#barriers p')].map((p) => p.textContent).join('; ');"),
      "The figures of the hits exclude 1 rock that passed with the centre above the top. Clearance is measured from "
      "the "
      "rock's lower side; it is negative if the centre passed above the top and the lower side below it.");
}

TEST(ReportInBrowser, ShowsTheFormsOfBlocks) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  const sample_run::Folder folder("report-blocks");
  sample_run::write_3d(folder);
  folder.write("summary.json", on_terrain(100).dump());
  const auto without_end = [](std::string text) {
    text.pop_back();
    return text;
  };
  folder.write("endpoints.csv", without_end(sample_run::endpoints_head) + ",a_m,b_m,c_m,short_axis_share\n" +
                                    without_end(sample_run::endpoint_row(0)) + ",2,1,0.9,0.5\n" +
                                    without_end(sample_run::endpoint_row(1)) + ",2,1.9,1,0.9\n");
  write_report(std::vector{folder.path}, folder.path / "report.html");
  EXPECT_EQ(said_in_page(folder.path / "report.html", R"(
    const part = document.querySelector('#shapes');
    const rows = [...part.querySelectorAll('tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent));
    return part.querySelectorAll('circle.dot').length + ' dots; ' +
      rows.map((row) => [0, 1, 2, 3, 8].map((k) => row[k]).join(' ')).join('; ');
  )"),
            "8 dots; flat 1 0.95 0.526 90; long 1 0.5 0.9 50");
}

TEST(ReportInBrowser, DrawsMaps) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const sample_run::Folder folder("report-maps");
  sample_run::write_3d(folder);
  folder.write("summary.json", on_terrain(100).dump());
  folder.write("endpoints.csv", sample_run::endpoints_head + sample_run::endpoint_row(0) + sample_run::endpoint_row(1));
  const std::vector<MapVisit> path{{{0, 0}, {4'000, 3'000, 10, 2}, 0, false},
                                   {{1, 0}, {8'000, 6'000, 20, 1}, 0, false}};
  const std::vector<std::span<const MapVisit>> paths{path};
  Maps maps(MapGrid({0, 0}, 5, {}));
  maps.add(2, paths);
  (void)write_maps(maps, {}, "", folder.path / "maps");
  write_report(std::vector{folder.path}, folder.path / "report.html");
  EXPECT_EQ(said_in_page(folder.path / "report.html", R"(
    const figures = [...document.querySelectorAll('#maps figure')];
    const energy = figures[1];
    const texts = [...energy.querySelectorAll('text')].map((t) => t.textContent).slice(-9).join('|');
    const has = (what) => figures.every((f) => f.querySelector(what)) ? what + ' ' : '';
    return figures.map((f) => f.querySelector('h4').textContent).join('|') + '; ' + texts + '; ' +
      has('image.relief') + has('image.cells') + has('.scale-bar') + has('.north') + has('.release') +
      '; ' + [0.25, 0.75].map((part) => {
        const cells = energy.querySelector('image.cells'), box = cells.getBoundingClientRect();
        const at = {clientX: box.left + part * box.width, clientY: box.top + box.height / 2};
        cells.dispatchEvent(new MouseEvent('mousemove', at));
        return document.getElementById('tip').textContent.split('\n')[1];
      }).join(', ');
  )"),
            "Maximum bounce height|Maximum total kinetic energy|Maximum velocity|Reach probability; "
            "y|Total kinetic energy, maximum [kJ]|30|100|300|1,000|3,000|Scale 1:75 on A4, cells of 5 m, "
            "up to 8 kJ|Coordinate system unknown; image.relief image.cells .scale-bar .north .release ; about 4 kJ, "
            "about 8 kJ");
}

TEST(ReportInBrowser, MapsHaveTheirStatedScaleOnPaper) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  for (const double side_m : {5.0, 70.0, 1000.0}) {
    // The length of the scale bar in metres, and in millimetres on paper.
    EXPECT_EQ(said_of(on_terrain(side_m), std::string(on_paper) + R"(
      const svg = document.querySelector('svg[aria-label="Plan with trajectories on the sheet"]');
      const bar = svg.querySelector('.scale-bar');
      const metres = Number(bar.querySelector('text').textContent.replace(/[ ,m]/g, ''));
      const drawn = mm(bar.querySelector('path').getBoundingClientRect().width);
      const note = [...svg.querySelectorAll('.map-note')].map((t) => t.textContent);
      const said = Number(/1:([0-9,.]+) on A4/.exec(note[0])[1].replace(/,/g, ''));
      return Math.abs(1000 * metres / drawn / said - 1) < 0.002 ? note[1] : metres + ' m in ' + drawn + ' mm at ' + note[0];
    )"),
              "Coordinate system unknown")
        << side_m;
  }
}

TEST(ReportInBrowser, MapsNameTheirCoordinateSystem) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = on_terrain(1000);
  summary["terrain"]["crs_wkt"] = R"(PROJCRS["MGI / Austria Lambert",BASEGEOGCRS["MGI"],ID["EPSG",31287]])";
  const std::string second = "return [...document.querySelectorAll('.map-note')].map((t) => t.textContent)[1];";
  EXPECT_EQ(said_of(summary, second), "MGI / Austria Lambert (EPSG:31287)");
  summary = on_terrain(1000);
  summary["project"]["terrain"]["crs"] = "local";
  EXPECT_EQ(said_of(summary, second), "Local coordinates");
}

TEST(ReportInBrowser, MapsAreAsWideAsThePageOrSideBySide) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(on_terrain(1000), std::string(on_paper) + R"(
    const box = document.createElement('div');
    box.className = 'columns';
    box.innerHTML = '<figure class="wide"><svg viewBox="0 0 900 9"></svg></figure><figure><svg viewBox="0 0 430 9"></svg></figure><figure></figure>';
    document.querySelector('main').append(box);
    const widths = [...box.querySelectorAll('svg')].map((svg) => mm(svg.getBoundingClientRect().width));
    return (widths[0] / 900).toFixed(4) + ' ' + (widths[1] / 430).toFixed(4);
  )"),
            "0.2044 0.2044");
}

TEST(ReportInBrowser, TwoFiguresFitOnAPage) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  constexpr double half_a_page_mm = 133;  // of A4 between its margins
  const std::string tallest = std::string(on_paper) + R"(
    const figures = [...document.querySelectorAll('figure')];
    return Math.max(...figures.map((figure) => mm(figure.getBoundingClientRect().height))).toFixed(0);
  )";
  for (const double side_m : {5.0, 1000.0}) {
    EXPECT_LT(std::stod(said_of(on_terrain(side_m), tallest)), half_a_page_mm) << side_m;
  }
  EXPECT_LT(std::stod(said_of(sample_run::summary("Section"), tallest)), half_a_page_mm);
}

TEST(ReportInBrowser, In3dEnergyIsDrawnOverTheDistanceTravelledAndEndPointsAreRunouts) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  const std::string said = R"(
    const labels = (title) => [...document.querySelectorAll('figure')].filter((f) => f.querySelector('h4').textContent.startsWith(title))
      .map((f) => [...f.querySelectorAll('.axis-label')].map((t) => t.textContent)[0] + ' ' + [...f.querySelectorAll('option')].map((o) => o.textContent).filter((t) => !/^[0-9]+$/.test(t)).join('/'));
    return ['Energy of one rock', 'End points', 'Runout', 'Total kinetic energy lost'].map((title) => labels(title).join()).join('; ');
  )";
  EXPECT_EQ(said_of(on_terrain(1000), said),
            "Distance travelled on plan [m] distance travelled/time; ; Runout on plan [m] ; "
            "Number of the impact number of the impact/distance travelled");
  EXPECT_EQ(said_of(sample_run::summary("Section"), said),
            "x [m] x/distance travelled/time; x of the end point [m] ; Runout on plan [m] ; "
            "Number of the impact number of the impact/position (x)");
}

}  // namespace
}  // namespace talus
