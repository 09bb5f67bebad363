// Each room is a library that is given the headers of the rooms below it and of no others (cmake/rooms.cmake).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/places.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

const fs::path source = fs::path(talus::places::in_source("/src"));

struct Room {
  std::string name;
  std::vector<std::string> lower;
};

// As src/CMakeLists.txt declares them, from low to high.
std::vector<Room> rooms() {
  std::ifstream in(source / "CMakeLists.txt");
  std::vector<Room> found;
  const std::regex declaration(R"(talus_room\((\w+)([ \w]*)\))");
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, match, declaration)) continue;
    Room room{match[1], {}};
    std::istringstream names(match[2]);
    for (std::string name; names >> name;) room.lower.push_back(name);
    found.push_back(room);
  }
  return found;
}

std::vector<std::string> folders_of_the_source() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source / "talus"))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  return names;
}

// The rooms of which a header would be found where a file of the room is compiled.
std::set<std::string> seen_by(const std::string& room) {
  std::ifstream in(fs::path(talus::places::binary_dir) / "rooms" / (room + ".txt"));
  std::set<std::string> seen;
  for (std::string folder; std::getline(in, folder);)
    for (const std::string& name : folders_of_the_source())
      if (!folder.empty() && fs::exists(fs::path(folder) / "talus" / name)) seen.insert(name);
  return seen;
}

TEST(Rooms, EveryFolderIsOne) {
  std::vector<std::string> names;
  for (const Room& room : rooms()) names.push_back(room.name);
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(folders_of_the_source()));
}

TEST(Rooms, SeeThemselvesAndWhatTheyKnow) {
  std::map<std::string, std::set<std::string>> known;  // of each room, at first or second hand
  for (const Room& room : rooms()) {
    std::set<std::string>& all = known[room.name];
    all.insert(room.name);
    for (const std::string& lower : room.lower) {
      ASSERT_TRUE(known.contains(lower)) << room.name << " knows " << lower << ", which is not below it";
      all.insert(known[lower].begin(), known[lower].end());
    }
    EXPECT_EQ(seen_by(room.name), all) << room.name;
  }
  EXPECT_GT(known.size(), 20U);
}

// A law of physics is a function of a contact, not of a terrain.
TEST(Rooms, LawsSeeNoTerrain) {
  for (const char* law : {"rocks", "impact", "sliding", "barriers"})
    EXPECT_FALSE(seen_by(law).contains("terrain")) << law;
  for (const char* law : {"impact", "sliding"}) EXPECT_FALSE(seen_by("terrain").contains(law)) << law;
}

// What is below the project does not know where its data came from.
TEST(Rooms, RocksSeeNoFiles) {
  for (const char* file : {"files", "gdal", "import", "project"})
    EXPECT_FALSE(seen_by("campaign").contains(file)) << file;
}

}  // namespace
}  // namespace talus
