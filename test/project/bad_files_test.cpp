// Project files that cannot be read: the exact text of each error.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "project/bad_project.hpp"
#include "support/input_folder.hpp"

namespace talus::project {
namespace {

class BadProjectFile : public testing_tools::InputFolder {
 protected:
  [[nodiscard]] std::string message(const std::filesystem::path& file) const {
    return refusal_of([&] { static_cast<void>(read_project(file)); });
  }
  [[nodiscard]] std::filesystem::path written(const std::string& text) const {
    write("slope.toml", text);
    return path("slope.toml");
  }
};

TEST_F(BadProjectFile, IsReadIfItIsGood) { EXPECT_EQ(message(written(good_project)), "was read"); }

TEST_F(BadProjectFile, Missing) {
  EXPECT_EQ(message(path("slope.toml")),
            "slope.toml: there is no such file. `talus new` writes a project to start from");
}

TEST_F(BadProjectFile, IsADirectory) {
  std::filesystem::create_directory(path("slope.toml"));
  EXPECT_EQ(message(path("slope.toml")),
            "slope.toml: this is a directory (expected a project file, for example slope.toml)");
}

TEST_F(BadProjectFile, IsADevice) {
  EXPECT_EQ(message("/dev/null"),
            "/dev/null: this is not a regular file (expected a project file, for example slope.toml)");
}

TEST_F(BadProjectFile, Unreadable) {
  const std::filesystem::path file = written(good_project);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  // root may read everything.
  EXPECT_EQ(message(file), geteuid() == 0 ? "was read" : "slope.toml: the file cannot be read (Permission denied)");
}

TEST_F(BadProjectFile, TooLarge) {
  const std::filesystem::path file = written(good_project);
  std::filesystem::resize_file(file, 300u << 20u);  // sparse, takes no space on the disk
  EXPECT_EQ(message(file),
            "slope.toml: the file has 300 MiB (a project file has at most 64 MiB). Keep a large terrain in a "
            "mesh file and name it by terrain.mesh");
}

TEST_F(BadProjectFile, Truncated) {
  const std::string text = good_project;
  EXPECT_EQ(message(written(text.substr(0, text.find("[10, -10]") + 4))),
            "slope.toml:7: this is not TOML (Error while parsing array: encountered end-of-file)");
}

TEST_F(BadProjectFile, IsNotText) {
  EXPECT_EQ(
      message(written("name = \"\xff\"")),
      "slope.toml:1: the byte 0xff is not UTF-8 (a project file is UTF-8; Latin-1 and Windows-1252 write "
      "letters such as \u00e4 and \u00e9 as single bytes). Save it as UTF-8; most editors offer this under Save as");
}

TEST_F(BadProjectFile, IsUtf16) {
  const std::string with_mark("\xff\xfen\0a\0", 6), without("n\0a\0m\0e\0", 8);
  for (const std::string& text : {with_mark, without}) {
    EXPECT_EQ(message(written(text)),
              "slope.toml: the file is UTF-16 (a project file is UTF-8). Save it as UTF-8; most editors offer "
              "this under Save as");
  }
}

TEST_F(BadProjectFile, NamesAMeshThatIsNotThere) {
  const std::filesystem::path file =
      written(changed(in_3d({{section, "mesh = \"bowl.obj\""}, {segments, R"(default = "Rock")"}})));
  EXPECT_EQ(message(file),
            "slope.toml:7: [terrain]: mesh is \"bowl.obj\" (there is no such file). The path is "
            "relative to the project file");
  write("bowl.obj", "v 0 0 0\n");
  EXPECT_EQ(message(file), "was read");
}

}  // namespace
}  // namespace talus::project
