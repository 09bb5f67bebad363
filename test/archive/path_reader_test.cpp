#include "talus/archive/path_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using sample_run::path_rows;
using sample_run::paths_head;

bool all(std::uint64_t) { return true; }

TEST(PathReader, ReadsPathByPath) {
  const sample_run::Folder folder("path-reader");
  folder.write("paths.csv", paths_head + path_rows(3) + path_rows(8) + path_rows(9));
  PathReader reader(folder.path / "paths.csv");
  for (const std::uint64_t rock : {3, 8, 9}) {
    ASSERT_TRUE(reader.next(all));
    EXPECT_EQ(reader.path().rock, rock);
    ASSERT_EQ(reader.path().rows.size(), 4U);
    EXPECT_EQ(reader.path().rows[1].state, PathState::impact);
    EXPECT_EQ(reader.path().rows[1].position_m, (std::array<double, 3>{3.1, 0, -12.2}));
    EXPECT_EQ(reader.path().rows[2].ke_rotational_J, 6766.13);
    EXPECT_EQ(reader.path().rows[3].event, 3U);
  }
  EXPECT_FALSE(reader.next(all));
}

TEST(PathReader, SkipsPathsThatAreNotSelected) {
  const sample_run::Folder folder("path-reader");
  folder.write("paths.csv", paths_head + path_rows(3) + path_rows(8) + path_rows(9));
  PathReader reader(folder.path / "paths.csv");
  ASSERT_TRUE(reader.next([](std::uint64_t rock) { return rock == 8; }));
  EXPECT_EQ(reader.path().rock, 8U);
  EXPECT_EQ(reader.path().rows.size(), 4U);
  EXPECT_FALSE(reader.next([](std::uint64_t rock) { return rock == 8; }));
}

std::string paths_message(const std::string& text) {
  const sample_run::Folder folder("path-reader");
  folder.write("paths.csv", text);
  try {
    PathReader reader(folder.path / "paths.csv");
    while (reader.next(all)) continue;
  } catch (const BadInput& bad) {
    return std::string(bad.what()).substr(folder.path.string().size() + 1);
  }
  return "was read";
}

TEST(PathReader, RefusesRowsThatAreNotAPath) {
  const std::string whole = path_rows(3), last = "3,3,ended,2.25,5,0,-12.2,0,0,0,0,0,0,0,0,0\n";
  const std::string cut = whole.substr(0, whole.size() - last.size());
  EXPECT_EQ(paths_message(paths_head), "was read");
  EXPECT_EQ(paths_message(paths_head + cut),
            "paths.csv: the path of rock 3 does not end (a path's last row has the state ended). The file was cut "
            "short or damaged; run the project again to write it anew");
  EXPECT_EQ(paths_message(paths_head + cut + path_rows(4)),
            "paths.csv:5: rock 4 begins before rock 3 has ended (a path's last row has the state ended). The file was "
            "cut or joined by hand; run the project again");
  EXPECT_EQ(paths_message(paths_head + "3,0,gliding,0,0.5,0,0,1.5,0,0,0,0,0,1125,0,119641.13\n"),
            "paths.csv:2: state: \"gliding\" is not a state (expected one of projectile, impact, sliding, rolling, "
            "barrier, ended)");
}

}  // namespace
}  // namespace talus
