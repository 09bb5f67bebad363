// Empirical distributions of a project: their files, the model, and the exact text of what is refused.

#include "talus/model/samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "support/input_folder.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing_tools::InputFolder;

class Samples : public InputFolder {
 protected:
  static std::string text(const std::string& seeder, const std::string& material = "") {
    return R"([terrain]
section = [[0, 10], [100, 0]]
[[material]]
name = "Rock"
)" + material +
           R"([[seeder]]
name = "Crest"
position = [1, 20]
rocks = 40
)" + seeder;
  }
  [[nodiscard]] Model model(const std::string& project) {
    write("slope.toml", project);
    Reading reading = read_project(path("slope.toml"));
    warnings_ = reading.warnings;
    project_ = reading.project;
    return build_model(reading.project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& project) {
    return refusal_of([&] { static_cast<void>(model(project)); });
  }
  static std::set<double> masses(const Model& model) {
    std::set<double> found;
    Simulator simulator(model);
    for (std::uint64_t rock = 0; rock < model.rocks(); ++rock) found.insert(simulator.simulate(rock, false).body.mass);
    return found;
  }

  Project project_;
};

TEST_F(Samples, AreDrawnFrom) {
  write("blocks.csv", "site;mass_kg;count\nA;120,5;3\nB;800;1\nC;50;0\n");
  const Model by_key = model(text("mass_kg = { distribution = \"empirical\", file = \"blocks.csv\" }\n"));
  EXPECT_EQ(warnings(), "");
  EXPECT_THAT(masses(by_key), ElementsAre(50, 120.5, 800));
  const Model weighted = model(
      text("mass_kg = { distribution = \"empirical\", file = \"blocks.csv\", column = \"Mass (kg)\", weight_column = "
           "\"count\" }\n"));
  EXPECT_THAT(masses(weighted), ElementsAre(120.5, 800));
}

TEST_F(Samples, MayBeOfMaterials) {
  write("rn.csv", "Rn\n0.2\n0.4\n");
  const Model built =
      model(text("mass_kg = 100\n",
                 "normal_restitution = { distribution = \"empirical\", file = \"rn.csv\", column = \"Rn\" }\n"
                 "friction_angle_deg = { distribution = \"empirical\", file = \"rn.csv\", column = \"Rn\" }\n"));
  const talus::Material& rock = built.ground.materials().front();
  EXPECT_EQ(rock.normal_restitution.draw(0.2), 0.2);
  EXPECT_EQ(rock.normal_restitution.draw(0.8), 0.4);
  EXPECT_NEAR(rock.friction_angle.draw(0.8), 0.4 * std::numbers::pi / 180, 1e-15);
}

TEST_F(Samples, AreKnownByTheFingerprintAndTheEcho) {
  const std::string project = text("mass_kg = { distribution = \"empirical\", file = \"m.csv\" }\n");
  const auto print_of = [&](const char* table) {
    write("m.csv", table);
    const Model built = model(project);
    return fingerprint_of(echo(project_), built);
  };
  EXPECT_EQ(print_of("mass_kg\n1\n2\n"), print_of("mass_kg\n2\n1\n"));
  EXPECT_NE(print_of("mass_kg\n1\n2\n"), print_of("mass_kg\n1\n3\n"));
  EXPECT_EQ(echo(project_)["seeder"][0]["mass_kg"].dump(), R"({"distribution":"empirical","file":"m.csv"})");
}

TEST_F(Samples, ReportAllProblemsOfTheirFiles) {
  write("m.csv", "mass_kg,weight\n1,1\nx,1\n-3,1\n4,\n5,-1\nnan,2\n");
  EXPECT_EQ(
      refusal(text("mass_kg = { distribution = \"empirical\", file = \"m.csv\", weight_column = \"weight\" }\n")),
      "slope.toml:9: seeder \"Crest\": mass_kg file m.csv:3: mass_kg is \"x\" (expected a number)\n"
      "slope.toml:9: seeder \"Crest\": mass_kg file m.csv:4: mass_kg is -3 (a rock has mass; expected 1e-9 to 1e12)\n"
      "slope.toml:9: seeder \"Crest\": mass_kg file m.csv:5: weight is empty (expected a number)\n"
      "slope.toml:9: seeder \"Crest\": mass_kg file m.csv:6: weight is -1 (a weight is not negative)\n"
      "slope.toml:9: seeder \"Crest\": mass_kg file m.csv:7: mass_kg is \"nan\" (expected a number)");
}

TEST_F(Samples, RefuseFilesWithoutAValue) {
  const std::string project = text("mass_kg = { distribution = \"empirical\", file = \"m.csv\", column = \"m\" }\n");
  write("m.csv", "m\n");
  EXPECT_THAT(refusal(project), HasSubstr("mass_kg file m.csv: has no rows (a sample has one value or more)"));
  write("m.csv", "mass\n1\n");
  EXPECT_THAT(refusal(project), HasSubstr("mass_kg file m.csv: has no column \"m\" (it has \"mass\")"));
  write("m.csv", "m,w\n1,0\n");
  EXPECT_THAT(
      refusal(text("mass_kg = { distribution = \"empirical\", file = \"m.csv\", column = \"m\", weight_column = "
                   "\"w\" }\n")),
      HasSubstr("has only weights of 0 (no value could be drawn)"));
  std::filesystem::remove(path("m.csv"));
  EXPECT_THAT(
      refusal(project),
      HasSubstr("slope.toml:9: seeder \"Crest\": mass_kg file is \"m.csv\" (there is no such file). The path is "
                "relative to the project file"));
  write("m.gpkg", "");
  EXPECT_THAT(
      refusal(text("mass_kg = { distribution = \"empirical\", file = \"m.gpkg\" }\n")),
      HasSubstr("mass_kg file is \"m.gpkg\" (expected a text file that ends in .csv, .xyz, .txt, .pts or .dat)"));
}

TEST_F(Samples, HaveNoParameters) {
  write("m.csv", "mass_kg\n1\n");
  EXPECT_EQ(
      refusal(text("mass_kg = { mean = 5, distribution = \"empirical\", file = \"m.csv\", rel_max = 2 }\n")),
      "slope.toml:9: seeder \"Crest\": mass_kg mean is given for a sample (the file has its values, and none is cut "
      "off). Leave it out\n"
      "slope.toml:9: seeder \"Crest\": mass_kg rel_max is given for a sample (the file has its values, and none is "
      "cut off). Leave it out");
  EXPECT_EQ(refusal(text("mass_kg = { distribution = \"empirical\" }\n")),
            "slope.toml:9: seeder \"Crest\": mass_kg file is missing");
  EXPECT_EQ(refusal(text("mass_kg = { mean = 500, distribution = \"normal\", std_dev = 1, file = \"m.csv\" }\n")),
            "slope.toml:9: seeder \"Crest\": mass_kg file is given without a sample (it would have no effect). Write "
            "distribution = \"empirical\"");
  EXPECT_EQ(refusal(text("mass_kg = { distribution = \"normal\", std_dev = 1 }\n")),
            "slope.toml:9: seeder \"Crest\": mass_kg mean is missing");
}

}  // namespace
}  // namespace talus::project
