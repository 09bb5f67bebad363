// [report]: reading it, its logo, and what of it a report may change.

#include "talus/project/title_block.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "project/bad_project.hpp"
#include "support/input_folder.hpp"
#include "support/pictures.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using testing_tools::small_png;

class TitleBlockFile : public testing_tools::InputFolder {
 protected:
  [[nodiscard]] std::string message(const std::string& report) const {
    write("slope.toml", good_project + ("\n[report]\n" + report + "\n"));
    return refusal_of([&] { static_cast<void>(read_project(path("slope.toml"))); });
  }
};

TEST_F(TitleBlockFile, IsEchoed) {
  write("logo.png", small_png(20, 10));
  const std::string keys =
      "client = \"Bergheim\"\nauthor = \"A. Meier\"\nrevision = \"B\"\nlogo = \"logo.png\"\npaper = \"A3\"";
  EXPECT_EQ(message(keys), "was read");
  const Reading reading = read_project(path("slope.toml"));
  EXPECT_EQ(reading.warnings.text(), "");
  EXPECT_EQ(
      echo(reading.project).at("report").dump(),
      R"({"client":"Bergheim","author":"A. Meier","revision":"B","logo":"logo.png","paper":"A3","units":"metric"})");
  EXPECT_EQ(echo(read_project_text(good_project, "slope.toml").project).at("report").dump(),
            R"({"paper":"A4","units":"metric"})");
}

TEST_F(TitleBlockFile, RefusesOtherPapersAndLogos) {
  EXPECT_EQ(message("paper = \"A0\""), "slope.toml:33: [report]: paper is \"A0\" (expected \"A4\" or \"A3\")");
  const std::string hint = ". Name a PNG or JPEG picture; the path is relative to the project file";
  EXPECT_EQ(message("logo = \"logo.png\""),
            "slope.toml:33: [report]: logo is \"logo.png\" (there is no such file)" + hint);
  write("logo.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  EXPECT_EQ(message("logo = \"logo.svg\""),
            "slope.toml:33: [report]: logo is \"logo.svg\" (it is neither a PNG nor a JPEG picture)" + hint);
  std::filesystem::create_symlink("/etc/hostname", path("link.png"));
  EXPECT_NE(message("logo = \"link.png\"").find("it is a link to outside the project's folder"), std::string::npos);
}

TEST_F(TitleBlockFile, ChangesNoResult) {
  const auto fingerprint = [](const std::string& text) {
    const Reading reading = read_project_text(text, "slope.toml");
    Problems warnings;
    return fingerprint_of(echo(reading.project), build_model(reading.project, warnings));
  };
  const std::string plain = fingerprint(good_project);
  EXPECT_EQ(
      fingerprint(good_project + std::string("\n[report]\nauthor = \"A. Meier\"\npaper = \"A3\"\nunits = \"us\"\n")),
      plain);
  EXPECT_NE(fingerprint(good_project + std::string("\n[sampling]\nseed = 2\n")), plain);
}

std::string refusal_of_overrides(const std::vector<std::string>& overrides) {
  try {
    return title_block_settings(overrides).given.dump();
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
}

TEST_F(TitleBlockFile, OverridesHaveOnlyWhatIsGiven) {
  EXPECT_EQ(refusal_of_overrides({}), "{}");
  EXPECT_EQ(refusal_of_overrides({"report.author=A. Meier", "report.paper=A3", "report.units=us"}),
            R"({"author":"A. Meier","paper":"A3","units":"us"})");
  write("logo.png", small_png(20, 10));
  const TitleBlockSettings settings = title_block_settings({"report.logo=" + path("logo.png").string()});
  EXPECT_TRUE(settings.logo.starts_with("data:image/png;base64,iVBOR")) << settings.logo;
}

TEST_F(TitleBlockFile, OverridesOfResultsAreRefused) {
  EXPECT_EQ(
      refusal_of_overrides({"sampling.seed=2", "report.autor=A. Meier", "report.paper=A5", "report.units=ft"}),
      "--set sampling.seed=2: sampling cannot be set here (a report is made of finished results; only settings of "
      "[report] can be given). Run the project again with this setting\n"
      "--set report.autor=A. Meier: [report]: unknown key \"autor\". Did you mean \"author\"?\n"
      "--set report.paper=A5: [report]: paper is \"A5\" (expected \"A4\" or \"A3\")\n"
      "--set report.units=ft: [report]: units is \"ft\" (expected \"metric\" or \"us\")");
  EXPECT_EQ(
      refusal_of_overrides({"report.logo=not-there.png"}),
      "--set report.logo=not-there.png: [report]: logo is \"not-there.png\" (No such file or directory). Name a PNG "
      "or JPEG picture; the path is relative to the current folder");
}

}  // namespace
}  // namespace talus::project
