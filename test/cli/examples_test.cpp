// Every example of the repository passes `talus check` and runs.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/run_files.hpp"
#include "support/places.hpp"

namespace talus {
namespace {

using namespace test;

TEST(Examples, PassTheCheckAndRun) {
  const Workplace place;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(talus::places::in_source("/examples"))) {
    if (entry.path().extension() != ".toml") continue;
    if (entry.path().stem() == "study") {
      const std::string out = (place / "study").string();
      const Said calibrated = talus_says("calibrate " + entry.path().string() + " -o " + out);
      EXPECT_EQ(calibrated.exit_code, 0) << calibrated.text;
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / "report.html"));
      continue;
    }
    ++count;
#ifndef TALUS_HAS_GDAL
    const std::string stem = entry.path().stem().string();
    if (stem == "maungawhau" || stem == "barrier-design" || stem == "crater" || stem == "boulders" ||
        stem == "first-gis-run")
      continue;  // on a raster
#endif
    const std::string file = entry.path().string(), out = (place / entry.path().stem().string()).string();
    const Said checked = talus_says("check " + file);
    EXPECT_EQ(checked.exit_code, 0) << checked.text;
    const Said ran = talus_says("run " + file + " -o " + out + " --rocks 50");
    EXPECT_EQ(ran.exit_code, 0) << ran.text;
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / "report.html")) << file;
  }
  EXPECT_GE(count, 5);
}

#ifdef TALUS_HAS_GDAL
// Both models, with the values of the library.
TEST(Examples, RocksFromTheCraterRimComeToRestInTheModel) {
  const Workplace place;
  for (const std::string model : {"lumped_mass", "rigid_sphere"}) {
    const std::string out = (place / model).string();
    const Said ran = talus_says("run " + talus::places::in_source("/examples/maungawhau/crater.toml") + " -o " + out +
                                " --rocks 500 --set analysis.model=" + model);
    EXPECT_EQ(ran.exit_code, 0) << ran.text;
    const auto ends = nlohmann::json::parse(bytes_of(out + "/summary.json")).at("end_reasons");
    EXPECT_GE(ends.value("at rest", 0), 475) << ran.text;
  }
}
#endif

}  // namespace
}  // namespace talus
