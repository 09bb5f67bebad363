#include "talus/files/ordinary_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/run_columns.hpp"
#include "support/sample_run.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/csv_reader.hpp"
#include "talus/import/las_file.hpp"
#include "talus/import/mesh_file.hpp"
#include "talus/import/point_file.hpp"

namespace talus {
namespace {

class OrdinaryFile : public ::testing::Test {
 protected:
  OrdinaryFile() {
    for (const char* name : {"pipe.csv", "pipe.las", "pipe.obj"}) {
      EXPECT_EQ(::mkfifo((folder_.path / name).c_str(), 0600), 0);
    }
    folder_.write("file", "");
  }

  template <class Read>
  [[nodiscard]] std::string refusal(Read&& read) const {
    try {
      read();
    } catch (const BadInput& bad) {
      std::string text = bad.what();
      const std::string folder = folder_.path.string() + "/";
      for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) text.erase(at, folder.size());
      return text;
    }
    return "was read";
  }

  sample_run::Folder folder_{"ordinary"};
};

TEST_F(OrdinaryFile, IsDistinguishedFromPipesAndDevices) {
  EXPECT_EQ(not_an_ordinary_file(folder_.path / "file"), std::nullopt);
  EXPECT_EQ(not_an_ordinary_file(folder_.path / "no such file"), std::nullopt);
  EXPECT_EQ(not_an_ordinary_file(folder_.path), "it is a folder");
  EXPECT_EQ(not_an_ordinary_file(folder_.path / "pipe.csv"), "it is a pipe");
  EXPECT_EQ(not_an_ordinary_file("/dev/null"), "it is a device");
  std::filesystem::create_symlink("/dev/zero", folder_.path / "link");
  EXPECT_EQ(not_an_ordinary_file(folder_.path / "link"), "it is a device");
}

TEST_F(OrdinaryFile, NoReaderWaitsForAPipe) {
  const auto& folder = folder_.path;
  EXPECT_EQ(refusal([&] { (void)read_point_file(folder / "pipe.csv"); }),
            "pipe.csv: cannot be read (it is a pipe). Name a file");
  EXPECT_EQ(refusal([&] { (void)read_las_file(folder / "pipe.las", {}); }),
            "pipe.las: cannot be read (it is not an ordinary file)");
  EXPECT_EQ(refusal([&] { (void)read_mesh_file(folder / "pipe.obj"); }),
            "pipe.obj: cannot be read (it is not an ordinary file)");
}

TEST_F(OrdinaryFile, NoReaderOfResultsWaitsForAPipe) {
  const auto& folder = folder_.path;
  EXPECT_EQ(refusal([&] { CsvReader(folder / "pipe.csv", endpoint_columns); }),
            "pipe.csv: cannot be opened (it is a pipe)");
  EXPECT_EQ(refusal([&] { CsvReader(folder, endpoint_columns); }),
            folder.string() + ": cannot be opened (it is a folder)");
  ASSERT_EQ(::mkfifo((folder / "summary.json").c_str(), 0600), 0);
  EXPECT_EQ(refusal([&] { (void)read_run_folder(folder); }),
            "summary.json: cannot be opened (it is a pipe). Name a folder that `talus run` has written");
}

}  // namespace
}  // namespace talus
