// --resume of a run whose results were lost, cut or changed since.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ChangedResults : public ::testing::Test {
 protected:
  ChangedResults() {
    const Said said = talus_says(command_);
    EXPECT_EQ(said.exit_code, 0) << said.text;
    whole_ = files_of(out_);
  }
  void cut(const std::string& name, std::uintmax_t bytes) const {
    fs::resize_file(out_ / name, fs::file_size(out_ / name) - bytes);
  }
  /// What is said of a change, which is undone by then.
  [[nodiscard]] std::string after(const std::function<void()>& change) const {
    change();
    const Said said = talus_says(command_ + " --resume");
    EXPECT_EQ(said.exit_code, 0) << said.text;
    EXPECT_EQ(differences(whole_, files_of(out_)), "");
    return said.text;
  }

  Workplace work_;
  fs::path out_ = work_ / "out";
  std::string command_ =
      "run " + write_slope_with_barrier(work_) + " --rocks 200 --set output.raster_cell_m=4 -o " + out_.string();
  std::map<std::string, std::string> whole_;
};

TEST_F(ChangedResults, AreRebuilt) {
  EXPECT_THAT(after([] {}), HasSubstr("is already complete in"));
  const auto begins_anew = [](const std::string& name) { return HasSubstr(name + " is not whole in "); };
  EXPECT_THAT(after([&] { fs::resize_file(out_ / "report.html", 0); }), begins_anew("report.html"));
  EXPECT_THAT(after([&] {
                const std::string rows = bytes_of(out_ / "paths.csv");
                cut("paths.csv", rows.size() - 1 - rows.rfind('\n', rows.size() - 2));  // at the end of a line
              }),
              begins_anew("paths.csv"));
  EXPECT_THAT(after([&] {
                std::fstream file(out_ / "endpoints.csv", std::ios::in | std::ios::out);
                file.seekp(200);
                file << '#';
              }),
              begins_anew("endpoints.csv"));
#ifdef TALUS_HAS_GDAL
  EXPECT_THAT(after([&] { fs::remove(out_ / "maps/deposits.tif"); }), begins_anew("maps/deposits.tif"));
  EXPECT_THAT(after([&] { cut("maps/passages.tif", 1); }), begins_anew("maps/passages.tif"));
  EXPECT_THAT(after([&] { cut("results.gpkg", 4096); }), begins_anew("results.gpkg"));
#endif
  EXPECT_THAT(after([&] { fs::remove(out_ / "files.json"); }), begins_anew("files.json"));
  EXPECT_THAT(after([&] { std::ofstream(out_ / "files.json") << "{\"files\": 3}"; }), begins_anew("files.json"));
}

TEST_F(ChangedResults, AReportMadeAgainIsNoChange) {
  EXPECT_EQ(talus_says("report " + out_.string()).exit_code, 0);
  EXPECT_THAT(talus_says(command_ + " --resume").text, HasSubstr("is already complete in"));
}

}  // namespace
}  // namespace talus::test
