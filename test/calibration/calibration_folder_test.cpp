// The folder of a calibration: the same bits on any number of threads and after a stop, files that other commands can
// read, and its report.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "calibration/calibrations.hpp"
#include "support/browser.hpp"
#include "support/projects.hpp"
#include "talus/calibration/result_files.hpp"
#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::calibration {
namespace {

using testing_tools::replaced;
using CalibrationFolders = Calibrations;

TEST_F(CalibrationFolders, GiveTheSameFilesOnAnyNumberOfThreadsAndAfterAStop) {
  observe(30, 0.7, 6, 13);
  const PreparedStudy study = prepared();
  static_cast<void>(calibrate_into(path("one"), study, {.threads = 1}));
  static_cast<void>(calibrate_into(path("three"), study, {.threads = 3}));

  std::atomic<bool> stop{false};
  std::size_t reached = 0;
  try {
    const StopScope scope(&stop);
    static_cast<void>(
        calibrate_into(path("stopped"), study, {.threads = 2, .progress = [&](std::size_t done, std::size_t) {
                                                  reached = done;
                                                  if (done > 96) stop = true;
                                                }}));
    ADD_FAILURE() << "was not stopped";
  } catch (const Stopped&) {
  }
  EXPECT_LT(reached, 240U);
  EXPECT_FALSE(std::filesystem::exists(path("stopped/posterior.csv")));
  static_cast<void>(calibrate_into(path("stopped"), study, {}));
  for (const std::string file : {"posterior.csv", "sets.csv", "summary.json", "report.html", "best/site 1.toml"}) {
    EXPECT_EQ(bytes_of(path("one") / file), bytes_of(path("three") / file)) << file;
    EXPECT_EQ(bytes_of(path("one") / file), bytes_of(path("stopped") / file)) << file;
    EXPECT_NE(bytes_of(path("one") / file), "") << file;
  }
}

TEST_F(CalibrationFolders, WriteTheBestFitAsAProjectInItsPlace) {
  observe(30, 0.7, 6, 14);
  std::filesystem::create_directories(path("terrain"));
  const PreparedStudy study = prepared();
  const CalibrationResult result = calibrate_into(path("out"), study, {});
  project::Reading best = project::read_project(path("out/best/site 1.toml"));
  EXPECT_EQ(best.project.materials[0].tangential_restitution.mean, result.sets[result.best].values[0]);
  EXPECT_EQ(best.project.materials[0].tangential_restitution.std_dev, 0.04);
  const std::string text = bytes_of(path("out/best/site 1.toml"));
  EXPECT_NE(text.find("{ distribution = 'normal', mean = 0.3, std_dev = 0.04 }"), std::string::npos) << text;
  EXPECT_EQ(best.project.materials[0].roughness_deg.mean, result.sets[result.best].values[1]);
  EXPECT_NO_THROW(static_cast<void>(project::build_model(best.project, best.warnings)));
  const std::string header = "weight,score,material.Scree.tangential_restitution,material.Scree.roughness_deg,fixed:";
  EXPECT_EQ(bytes_of(path("out/posterior.csv")).substr(0, header.size()), header);
}

TEST_F(CalibrationFolders, DrawTheirReport) {
  if (!testing_tools::has_browser()) GTEST_SKIP() << "there is no chromium";
  observe(30, 0.7, 6, 14);
  std::filesystem::create_directories(path("terrain"));
  static_cast<void>(calibrate_into(path("out"), prepared(), {}));
  EXPECT_EQ(testing_tools::said_in_page(path("out/report.html"), R"(
    const main = document.getElementById('main');
    const titles = [...main.querySelectorAll('figure h4')].map((each) => each.textContent).join('; ');
    const isDrawn = [...main.querySelectorAll('figure svg')].every((svg) => svg.querySelector('.axis'));
    const dots = main.querySelectorAll('#pairs circle').length > 10;
    return [titles, isDrawn, dots, /NaN|undefined/.test(main.innerHTML)].join('; ');
  )"),
            "Scree: tangential restitution; Scree: roughness; Scree: tangential restitution, and Scree: roughness; "
            "Runout, stops; true; true; false");
}

TEST_F(CalibrationFolders, KeepTheLawsOfTheirStudyInThePosterior) {
  observe(30, 0.7, 6, 14);
  write("study.toml", replaced(study_text, "project = \"slope.toml\"",
                               "project = \"slope.toml\"\nset = [\"analysis.scale_rn_by_velocity=false\", "
                               "\"material.Scree.friction_angle_deg=35\"]"));
  static_cast<void>(calibrate_into(path("out"), prepared(), {}));
  const std::string posterior = bytes_of(path("out/posterior.csv")), header = posterior.substr(0, posterior.find('\n'));
  EXPECT_THAT(header, testing::HasSubstr(",fixed:analysis.scale_rn_by_velocity,"));
  EXPECT_THAT(header, testing::HasSubstr(",fixed:material.Scree.friction_angle_deg.mean"));
  EXPECT_THAT(header, testing::Not(testing::HasSubstr("fixed:material.Scree.roughness_deg")));
  EXPECT_THAT(header, testing::Not(testing::HasSubstr("fixed:material.Scree.normal_restitution")));

  write("predict.toml", slope + "[sampling]\nparameters = \"out/posterior.csv\"\nensembles = 10\n");
  const auto build = [&](std::vector<std::string> settings) {
    project::Reading reading = project::read_project(path("predict.toml"), {std::move(settings), {}, {}});
    static_cast<void>(project::build_model(reading.project, reading.warnings));
  };
  EXPECT_EQ(
      refusal_of([&] { build({}); }),
      "predict.toml:24: [sampling]: parameters out/posterior.csv:2: its study has analysis.scale_rn_by_velocity = "
      "false, and predict.toml has true (its parameters were found with that value). Give the project this value, "
      "or calibrate with that of the project\n"
      "predict.toml:24: [sampling]: parameters out/posterior.csv:2: its study has "
      "material.Scree.friction_angle_deg.mean = 35.0, and predict.toml has 30.0 (its parameters were found with "
      "that value). Give the project this value, or calibrate with that of the project");
  EXPECT_NO_THROW(build({"analysis.scale_rn_by_velocity=false", "material.Scree.friction_angle_deg=35"}));
}

}  // namespace
}  // namespace talus::calibration
