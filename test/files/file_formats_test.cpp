#include "talus/files/file_formats.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(FileFormats, FindsAFormatByTheEndingInAnyCase) {
  const FileFormat* format = format_of("survey.v2/Slope.PTS");
  ASSERT_NE(format, nullptr);
  EXPECT_EQ(format->ending, ".pts");
  EXPECT_EQ(format->kind, FileKind::point_text);
  EXPECT_TRUE(is_of_kind("slope.LAS", FileKind::las));
  EXPECT_FALSE(is_of_kind("slope.las", FileKind::point_text));
}

TEST(FileFormats, FindsNoneForOtherFiles) {
  for (const char* file : {"slope.dem", "slope", "slope.", "", "asc", ".asc", "slope.tif/"})
    EXPECT_EQ(format_of(file), nullptr) << file;
}

TEST(FileFormats, ListsTheEndingsOfAKind) { EXPECT_EQ(endings_in_words(FileKind::mesh), ".obj, .stl or .ply"); }

TEST(FileFormats, NamesTextAndLasPoints) {
  EXPECT_EQ(name_of(FileKind::raster), "raster");
  EXPECT_EQ(name_of(FileKind::point_text), "points");
  EXPECT_EQ(name_of(FileKind::las), "points");
}

}  // namespace
}  // namespace talus
