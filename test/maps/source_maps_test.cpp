#include "talus/maps/source_maps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "talus/core/problems.hpp"
#include "talus/maps/map_files.hpp"

namespace talus {
namespace {

using test::Workplace;
using testing::ElementsAre;

using Names = std::vector<std::string>;

TEST(SourceFolders, AreNamedAfterTheirSources) {
  const Names names{"Wand 3", "Höhle (Süd)", "north-east_2.b", "断崖"};
  EXPECT_EQ(folder_names(names), names);
}

TEST(SourceFolders, HaveNamesThatEverySystemAllows) {
  const Names names{"a/b\\c",   "<b>bold</b>",     "..",    ".", "", " . hidden. ", "con",
                    "Com1.txt", "line\nbreak\x7f", "*?\"|:"};
  EXPECT_THAT(folder_names(names), ElementsAre("a_b_c", "_b_bold__b_", "source", "source-2", "source-3", "hidden",
                                               "_con", "_Com1.txt", "line_break_", "_____"));
}

TEST(SourceFolders, AreDistinct) {
  const Names names{"a/b", "a_b", "A_B", "a_b-2", "a:b", "x"};
  EXPECT_THAT(folder_names(names), ElementsAre("a_b", "a_b-2", "A_B-3", "a_b-2-2", "a_b-4", "x"));
}

TEST(SourceFolders, TruncateLongNamesBetweenCharacters) {
  std::string letters = "x";
  for (int k = 0; k < 80; ++k) letters += "ä";  // two bytes each: byte 100 is the second of one
  const Names names{letters, std::string(300, 'y'), std::string(99, 'z') + " and more"};
  const Names found = folder_names(names);
  EXPECT_EQ(found[0], letters.substr(0, 99));
  EXPECT_EQ(found[1], std::string(100, 'y'));
  EXPECT_EQ(found[2], std::string(99, 'z'));
}

#ifdef TALUS_HAS_GDAL

Maps one_rock_at(std::int32_t column) {
  Maps maps(MapGrid({0, 0}, 1, {}));
  const std::vector<MapVisit> visits{{{column, 0}, {1, 1, 1, 1}, 0, true}};
  const std::span<const MapVisit> list(visits);
  maps.add(1, std::span(&list, 1));
  return maps;
}

std::vector<Maps> three_sources() {
  std::vector<Maps> maps;
  maps.push_back(one_rock_at(3));
  maps.emplace_back(MapGrid({0, 0}, 1, {}));  // without a rock
  maps.push_back(one_rock_at(5));
  return maps;
}
const Names three_names{"a/b", "nothing", "a, \"b\""};

TEST(SourceMaps, AreInAFolderForEachSourceWithRocks) {
  const Workplace work;
  write_source_maps(three_sources(), three_names, {}, "", work / "by_source");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(work / "by_source")) {
    found.insert(entry.path().filename());
  }
  EXPECT_THAT(found, ElementsAre("a, _b_", "a_b", "sources.csv"));
  EXPECT_EQ(work.read("by_source/sources.csv"), "folder,source,rocks\na_b,a/b,1\n\"a, _b_\",\"a, \"\"b\"\"\",1\n");
  EXPECT_TRUE(std::filesystem::exists(work / "by_source/a_b/energy_total_mean_kJ.tif"));
  EXPECT_TRUE(std::filesystem::exists(work / "by_source/a_b/energy_total_mean_kJ.qml"));
}

TEST(SourceMaps, OfAnEarlierRunAreRemovedButNoOtherFiles) {
  const Workplace work;
  write_source_maps(three_sources(), three_names, {}, "", work / "by_source");
  work.write("by_source/a_b/mine.tif", "somebody else's");
  std::filesystem::create_directory(work / "elsewhere");
  work.write("elsewhere/passages.tif", "somebody else's");
  std::filesystem::create_directory_symlink(work / "elsewhere", work / "by_source/link");
  remove_source_maps(work / "by_source");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(work / "by_source")) {
    found.insert(entry.path().lexically_relative(work / "by_source"));
  }
  EXPECT_THAT(found, ElementsAre("a_b", "a_b/mine.tif", "link"));
  EXPECT_TRUE(std::filesystem::exists(work / "elsewhere/passages.tif"));

  std::filesystem::remove_all(work / "by_source");
  write_source_maps(three_sources(), three_names, {}, "", work / "by_source");
  remove_source_maps(work / "by_source");
  EXPECT_FALSE(std::filesystem::exists(work / "by_source"));
  remove_source_maps(work / "by_source");  // does nothing without a folder
}

TEST(SourceMaps, RefuseAFolderThatCannotBeCreated) {
  const Workplace work;
  std::filesystem::create_directory(work / "by_source");
  work.write("by_source/a_b", "a file in the way");
  try {
    write_source_maps(three_sources(), three_names, {}, "", work / "by_source");
    ADD_FAILURE() << "was written";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.what(), (work / "by_source/a_b").string() +
                              ": cannot create this folder (Not a directory). Choose another folder with -o");
  }
}

#endif

}  // namespace
}  // namespace talus
