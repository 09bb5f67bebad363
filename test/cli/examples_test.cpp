// Every example of the repository passes `talus check` and runs.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program.hpp"

namespace talus {
namespace {

using namespace test;

TEST(Examples, PassTheCheckAndRun) {
  const Workplace place;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TALUS_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
#ifndef TALUS_HAS_GDAL
    const std::string stem = entry.path().stem().string();
    if (stem == "maungawhau" || stem == "barrier-design" || stem == "first-gis-run") continue;  // on a raster
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

}  // namespace
}  // namespace talus
