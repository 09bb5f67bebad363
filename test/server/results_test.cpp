// Files and maps of a run over the API.

#include "server/served_results.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Texts;

using Results = testing_tools::ServedResults;

TEST_F(Results, AreTheFilesOfTheRun) {
  const Json files = of("/files").json()["files"];
  std::map<std::string, std::uint64_t> listed;
  for (const Json& file : files) listed[file["name"]] = file["bytes"];
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    const std::string name = entry.path().lexically_relative(folder_).generic_string();
    if (!entry.is_regular_file() || name == "run.json") continue;
    ASSERT_TRUE(listed.contains(name)) << name;
    EXPECT_EQ(listed[name], entry.file_size());
    const Reply reply = of("/files/" + name);
    EXPECT_EQ(reply.status, 200) << name;
    EXPECT_EQ(reply.body, test::bytes_of(entry.path())) << name;
    const auto disposition = reply.headers.find("Content-Disposition");
    ASSERT_NE(disposition, reply.headers.end());
    EXPECT_EQ(disposition->second, "attachment; filename*=UTF-8''" + entry.path().filename().string());
    listed.erase(name);
  }
  EXPECT_TRUE(listed.empty()) << listed.begin()->first;
}

TEST_F(Results, DoNotIncludeOtherFiles) {
  std::filesystem::create_symlink("/etc/passwd", folder_ / "link.csv");
  for (const char* name : {"run.json", "../../../slope.toml", "%2e%2e/%2e%2e/slope.toml", "maps", "maps/",
                           "nothing.csv", "link.csv", "/etc/passwd", "%2fetc%2fpasswd", ".", "maps/../summary.json"})
    EXPECT_EQ(of(std::string("/files/") + name).status, 404) << name;
  for (const char* name : {"nothing", "../endpoints", "passages.tif", "by_source/x/passages", "%2e%2e/passages"})
    EXPECT_EQ(of(std::string("/maps/") + name).status, 404) << name;
}

TEST_F(Results, AreRegularFilesOfTheirFolder) {
  const std::filesystem::path summary = folder_ / "summary.json", elsewhere = base_ / "elsewhere.json";
  const auto expect_none = [&] {
    for (const char* what : {"/summary", "/paths", "/endpoints", "/statistics?of=x_m", "/barriers", "/maps"})
      EXPECT_EQ(of(what).problem(), id_ + ": this run has no results (its summary.json is not a regular file)") << what;
    EXPECT_EQ(run(id_)["has_results"], false);
  };
  std::filesystem::rename(summary, elsewhere);
  std::filesystem::create_symlink(elsewhere, summary);
  expect_none();
  std::filesystem::remove(summary);
  ASSERT_EQ(mkfifo(summary.c_str(), 0600), 0);
  expect_none();
  std::filesystem::remove(summary);
  std::filesystem::rename(elsewhere, summary);
  EXPECT_EQ(of("/summary").status, 200);
}

#ifdef TALUS_HAS_GDAL
TEST_F(Results, OfMapsAgreeWithTheFiles) {
  const Json maps = of("/maps").json()["maps"];
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "maps"))
    files += entry.path().extension() == ".tif" ? 1 : 0;
  EXPECT_EQ(maps.size(), files);
  EXPECT_EQ(maps[0]["name"], "passages");
  EXPECT_TRUE(maps[0]["source"].is_null());
  for (const Json& map : maps) {
    const ArraysOf values(of("/maps/" + map["name"].get<std::string>()));
    const auto cells = values.get<float>("values", "f32");
    EXPECT_EQ(cells.size(), values.header["columns"].get<std::size_t>() * values.header["rows"].get<std::size_t>());
    float most = 0;
    for (const float value : cells) most = std::isnan(value) ? most : std::max(most, value);
    EXPECT_EQ(most, map["most"].get<float>()) << map["name"];
    const Json& classes = values.header["classes"];
    EXPECT_EQ(classes, map["classes"]);
    EXPECT_EQ(classes[0]["from"], 0);
    for (std::size_t k = 1; k < classes.size(); ++k) EXPECT_EQ(classes[k]["from"], classes[k - 1]["to"]);
    EXPECT_TRUE(classes.back()["to"].is_null());
  }
  // Every rock at rest is counted in a cell of the map.
  const ArraysOf deposits(of("/maps/deposits"));
  const auto cells = deposits.get<float>("values", "f32");
  const Json& header = deposits.header;
  for (const Texts& row : endpoints()) {
    if (row[11] != "at rest") continue;
    const auto column = static_cast<std::size_t>((std::stod(row[2]) - header["origin"][0].get<double>()) /
                                                 header["cell"][0].get<double>());
    const auto line = static_cast<std::size_t>((std::stod(row[3]) - header["origin"][1].get<double>()) /
                                               header["cell"][1].get<double>());
    EXPECT_GE(cells[line * header["columns"].get<std::size_t>() + column], 1) << row[0];
  }
}
#endif

}  // namespace
}  // namespace talus
