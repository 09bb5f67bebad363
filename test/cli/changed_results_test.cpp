// --resume of a run whose results have been lost, truncated or changed.

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
  /// Makes a change, resumes the run and expects the original results; returns the output.
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
  const auto begins_anew = [](const std::string& name) { return HasSubstr(name + " is incomplete in "); };
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

// Only the record distinguishes results of an earlier version, which may have other names, from the user's own files.
TEST_F(ChangedResults, AreRemovedIfThisRunDoesNotMakeThem) {
  const fs::path outside = work_ / "elsewhere";
  fs::create_directories(outside);
  fs::create_directories(out_ / "maps/folder.tif");
  fs::create_directory_symlink(outside, out_ / "link");
  fs::create_symlink(outside / "theirs.csv", out_ / "link.csv");
  const std::vector<std::string> stale{"maps/energy_total_max_J.tif", "old.csv", "tables/old.csv"};
  const std::vector<std::string> not_listed{"mine.csv", "maps/energy_total_max_J.qml", "tables/mine.csv"};
  const std::vector<std::string> refused{"../elsewhere/theirs.csv",
                                         "link/theirs.csv",
                                         "link.csv",
                                         (outside / "theirs.csv").string(),
                                         "./mine.csv",
                                         "maps/../mine.csv",
                                         "maps/folder.tif",
                                         "",
                                         "files.json"};
  fs::create_directories(out_ / "tables");
  work_.write("elsewhere/theirs.csv", "theirs");
  auto record = nlohmann::json::parse(bytes_of(out_ / "files.json"));
  for (const std::string& name : stale) record["files"][name] = {{"bytes", 5}};
  for (const std::string& name : refused) record["files"][name] = {{"bytes", 6}};
  for (const auto* names : {&stale, &not_listed}) {
    for (const std::string& name : *names) work_.write("out/" + name, "rocks");
  }
  work_.write("out/files.json", record.dump());
  ASSERT_EQ(talus_says(command_ + " --seed 7").exit_code, 0);
  for (const std::string& name : stale) EXPECT_FALSE(fs::exists(out_ / name)) << name;
  for (const std::string& name : not_listed) EXPECT_TRUE(fs::exists(out_ / name)) << name;
  EXPECT_EQ(bytes_of(outside / "theirs.csv"), "theirs");
  EXPECT_TRUE(fs::is_symlink(out_ / "link.csv"));
  EXPECT_TRUE(fs::is_directory(out_ / "maps/folder.tif"));
  EXPECT_TRUE(fs::exists(out_ / "files.json"));
  // A run that is refused changes nothing.
  work_.write("out/mine.csv", "rocks");
  EXPECT_EQ(talus_says(command_ + " --resume").exit_code, 2);
  EXPECT_TRUE(fs::exists(out_ / "mine.csv"));
}

TEST_F(ChangedResults, AreNotRemovedIfTheyAreInputOfThisRun) {
  auto record = nlohmann::json::parse(bytes_of(out_ / "files.json"));
  record["files"]["old.toml"] = {{"bytes", 5}};
  work_.write("out/files.json", record.dump());
  fs::copy_file(work_ / "slope.toml", out_ / "old.toml");
  const std::string before = bytes_of(out_ / "old.toml");
  const Said said = talus_says("run " + (out_ / "old.toml").string() + " -q -o " + out_.string());
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, (out_ / "old.toml").string() + ": is in " + out_.string() +
                           " (it is a result of an earlier run, which this one replaces). Give the file another name, "
                           "or write elsewhere with -o\n");
  EXPECT_EQ(bytes_of(out_ / "old.toml"), before);
}

TEST_F(ChangedResults, DoNotIncludeAReportWrittenAgain) {
  EXPECT_EQ(talus_says("report " + out_.string()).exit_code, 0);
  EXPECT_THAT(talus_says(command_ + " --resume").text, HasSubstr("is already complete in"));
}

}  // namespace
}  // namespace talus::test
