// Results of finished sets on disk: those of the same study are found again, others are removed.

#include "talus/study/saved_sets.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/input_folder.hpp"

namespace talus::study {
namespace {

class SavedSetsFolder : public testing_tools::InputFolder {};

TEST_F(SavedSetsFolder, KeepsResults) {
  SavedSets(path(""), "study").save(96, {"first", std::string("a\0b", 3)});
  const SavedSets again(path(""), "study");
  EXPECT_EQ(again.size(), 2u);
  EXPECT_EQ(again.of(96), "first");
  EXPECT_EQ(again.of(97), std::string_view("a\0b", 3));
  EXPECT_EQ(again.of(0), std::nullopt);
}

TEST_F(SavedSetsFolder, RemovesThoseOfAnotherStudy) {
  SavedSets(path(""), "study").save(0, {"first"});
  EXPECT_EQ(SavedSets(path(""), "another").size(), 0u);
  EXPECT_FALSE(std::filesystem::exists(path("sets/0000000.sets")));
}

TEST_F(SavedSetsFolder, RemovesDamagedFiles) {
  const SavedSets saved(path(""), "study");
  saved.save(0, {"first"});
  std::filesystem::resize_file(path("sets/0000000.sets"), std::filesystem::file_size(path("sets/0000000.sets")) - 1);
  saved.save(5, {"sixth"});
  write("sets/0000009.sets", "nothing of this kind");
  const SavedSets again(path(""), "study");
  EXPECT_EQ(again.size(), 1u);
  EXPECT_EQ(again.of(5), "sixth");
  EXPECT_FALSE(std::filesystem::exists(path("sets/0000000.sets")));
  EXPECT_FALSE(std::filesystem::exists(path("sets/0000009.sets")));
}

}  // namespace
}  // namespace talus::study
