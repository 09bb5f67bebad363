#include "talus/files/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

class PlaceOfFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const std::string& name) const {
    try {
      static_cast<void>(place_of_file(folder_.path / name));
    } catch (const BadInput& bad) {
      return std::string(bad.what()).substr(folder_.path.string().size() + 1);
    }
    return "has a place";
  }
  [[nodiscard]] std::string place(const std::string& name) const {
    return place_of_file(folder_.path / name).lexically_normal().lexically_relative(folder_.path).string();
  }

  sample_run::Folder folder_{"output"};
};

TEST(OutputFile, DoesNotWriteThroughLinksInItsWay) {
  const sample_run::Folder folder{"output_part"};
  folder.write("other", "stays");
  const auto write = [&](const char* name) {
    OutputFile file(folder.path / name);
    file.write("new");
    file.commit();
    return fs::is_regular_file(fs::symlink_status(folder.path / name)) && fs::file_size(folder.path / name) == 3;
  };
  fs::create_symlink("other", folder.path / "a.part");
  EXPECT_TRUE(write("a"));
  EXPECT_EQ(fs::file_size(folder.path / "other"), 5U);
  ASSERT_EQ(::mkfifo((folder.path / "b.part").c_str(), 0600), 0);
  EXPECT_TRUE(write("b"));
  folder.write("c.part", "what an earlier program has left");
  EXPECT_TRUE(write("c"));
}

TEST(OutputFile, BuffersSmallPieces) {
  const sample_run::Folder folder{"output_gathered"};
  const auto written = [&] { return fs::file_size(folder.path / "table.part"); };
  const std::string row(99, 'x');
  for (const bool goes_on : {false, true}) {
    if (goes_on) folder.write("table.part", "");
    auto file = goes_on ? OutputFile(folder.path / "table", 0) : OutputFile(folder.path / "table");
    for (int k = 0; k < 2000; ++k) file.write(row);
    EXPECT_EQ(written(), 0U);
    file.sync();
    EXPECT_EQ(written(), 2000 * row.size());
  }
}

TEST_F(PlaceOfFile, MayBeAnOrdinaryFileOrNotExist) {
  folder_.write("file", "");
  EXPECT_EQ(place("file"), "file");
  EXPECT_EQ(place("new"), "new");
}

TEST_F(PlaceOfFile, IsTheTargetOfLinks) {
  fs::create_directories(folder_.path / "a/b");
  folder_.write("file", "");
  fs::create_symlink("../../file", folder_.path / "a/b/link");
  fs::create_symlink("a/b/link", folder_.path / "link");
  fs::create_symlink(folder_.path / "not there yet", folder_.path / "dangling");
  EXPECT_EQ(place("link"), "file");
  EXPECT_EQ(place("dangling"), "not there yet");
  fs::create_symlink("round", folder_.path / "round");
  EXPECT_EQ(refusal("round"),
            "round: cannot write this file (Too many levels of symbolic links). Choose another folder with -o");
}

TEST_F(PlaceOfFile, MustNotBeAFolderOrDevice) {
  ASSERT_EQ(::mkfifo((folder_.path / "pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", folder_.path / "link");
  fs::create_directories(folder_.path / "folder");
  fs::create_symlink("/dev/null", folder_.path / "null");
  const std::string hint = "). Name an ordinary file, or one that does not exist yet";
  EXPECT_EQ(refusal("pipe"), "pipe: cannot write this file (it is a pipe" + hint);
  EXPECT_EQ(refusal("link"), "link: cannot write this file (it is a pipe" + hint);
  EXPECT_EQ(refusal("folder"), "folder: cannot write this file (it is a folder" + hint);
  EXPECT_EQ(refusal("null"), "null: cannot write this file (it is a device" + hint);
}

}  // namespace
}  // namespace talus
