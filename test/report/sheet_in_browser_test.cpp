// The sheet that a report prints first, its title block, and the inputs that it lists.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "report/report_in_browser.hpp"

namespace talus {
namespace {

using testing_tools::has_browser;

/// The title block's entries and the names of the drawings on the sheet.
constexpr auto on_the_sheet = R"(
  const texts = (what) => [...document.querySelectorAll('#sheet ' + what)].map((node) => node.textContent);
  return [texts('.title-block .cell').join('|'), texts('.drawings h4').join('|'), texts('.map-note').join('|')].join('; ');
)";

TEST(ReportSheet, HasASheetWithWhatTheTitleBlockGives) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = on_terrain(1000);
  summary["terrain"]["crs_wkt"] = R"(PROJCRS["MGI / Austria Lambert",BASEGEOGCRS["MGI"],ID["EPSG",31287]])";
  EXPECT_THAT(said_of(summary, on_the_sheet),
              ::testing::MatchesRegex(
                  R"(TitleTerrain\|Date[-0-9]+\|ProgramTalus 0.1.0\|Scale on A4plan 1:[0-9,]+, section 1:[0-9,]+; )"
                  R"(Plan with trajectories\|Section with trajectories; )"
                  R"(Scale 1:[0-9,]+ on A4\|MGI / Austria Lambert \(EPSG:31287\)\|Scale 1:[0-9,]+ on A4, both axes)"));
  summary["project"]["report"] = {{"client", "<b>Bergheim</b>"}, {"project", "K12"},      {"number", "7"},
                                  {"author", "A. Meier"},        {"checked", "B. Rossi"}, {"revision", "C"},
                                  {"date", "May 2026"},          {"text", "Draft"},       {"paper", "A3"}};
  EXPECT_THAT(
      said_of(summary, on_the_sheet),
      ::testing::StartsWith(
          "Client&lt;b&gt;Bergheim&lt;/b&gt;|ProjectK12|TitleTerrain|Number7|RevisionC|DateMay 2026|AuthorA. Meier|"
          "CheckedB. Rossi|ProgramTalus 0.1.0|Scale on A3plan 1:"));
}

TEST(ReportSheet, TheSheetIsOnPaperAlone) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(said_of(on_terrain(1000), "return getComputedStyle(document.getElementById('sheet')).display;"), "none");
  EXPECT_EQ(said_of(on_terrain(1000), std::string(on_paper) +
                                          "return getComputedStyle(document.getElementById('sheet')).display + ' ' + "
                                          "(mm(document.querySelector('.sheet').scrollHeight) <= 268);"),
            "block true");
}

TEST(ReportSheet, TextsOfThePaperStayTexts) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = sample_run::summary("Names");
  summary["project"]["report"] = {{"client", "a\"; } body { display: none } </style>\\ü"}};
  EXPECT_EQ(said_of(summary, R"(
    const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]).length;
    return document.styleSheets.length + ' ' + getComputedStyle(document.body).display;
  )"),
            "2 block");
}

TEST(ReportSheet, ListsInputsSourcesAndDefaults) {
  if (!has_browser()) GTEST_SKIP() << "there is no chromium";
  auto summary = sample_run::summary("Inputs");
  summary["project"]["analysis"]["gravity_m_s2"] = 9.81;
  summary["inputs"] = {{"files", {{{"name", "slope.toml"}, {"bytes", 1234}, {"sha256", std::string(64, 'a')}}}},
                       {"material_sources",
                        {{{"material", "Type One"},
                          {"like", "talus_cover"},
                          {"keys", {"normal_restitution", "friction_angle_deg"}},
                          {"source", "A book"}}}}};
  EXPECT_EQ(said_of(summary, rows_of("Input files") + "return rows.join('; ');"),
            "File|Size [bytes]|SHA-256; slope.toml|1,234|" + std::string(64, 'a'));
  EXPECT_EQ(said_of(summary, rows_of("Sources of the materials") + "return rows.join('; ');"),
            "Material|Library|Values|Source; Type One|talus_cover|normal restitution, friction angle|A book");
  EXPECT_EQ(said_of(summary, rows_of("Analysis") + "return rows.join('; ');"),
            "Setting|Value|Default; Model|lumped mass|; Rotation|yes|; Gravity [m/s²]|9.81|9.80665");
}

}  // namespace
}  // namespace talus
