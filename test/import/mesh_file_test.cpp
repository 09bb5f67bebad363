#include "talus/import/mesh_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <random>

#include "support/mesh_files.hpp"
#include "talus/import/mesh_formats.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using Corners = std::array<std::uint32_t, 3>;

class MeshFile : public MeshFiles {};

TEST_F(MeshFile, RefusesFilesThatCannotBeRead) {
  EXPECT_EQ(refusal("nowhere.obj"),
            "nowhere.obj: cannot be read (No such file or directory). Paths are relative to the project file");
  std::filesystem::create_directory(path("folder.stl"));
  EXPECT_EQ(refusal("folder.stl"), "folder.stl: cannot be read (it is a folder). Name a file");
  EXPECT_EQ(refusal("empty.ply", ""), "empty.ply: is empty (it has no bytes)");
  EXPECT_EQ(refusal("slope.dxf", "0\n"),
            "slope.dxf: is not a mesh that Talus can read (its extension is \".dxf\"; expected .obj, .stl or .ply). "
            "Convert it, or give the file the extension of its format");
  EXPECT_EQ(refusal("slope", "0\n"),
            "slope: is not a mesh that Talus can read (its name has no extension; expected .obj, .stl or .ply). "
            "Convert it, or give the file the extension of its format");
}

TEST_F(MeshFile, RefusesDevices) {
  std::filesystem::create_symlink("/dev/zero", path("endless.obj"));
  EXPECT_EQ(refusal("endless.obj"), "endless.obj: cannot be read (it is not an ordinary file)");
}

TEST_F(MeshFile, RefusesFilesThatAreTooLarge) {
  std::ofstream{path("huge.obj")} << "v 0 0 0\n";
  std::error_code error;
  std::filesystem::resize_file(path("huge.obj"), largest_mesh_file_bytes, error);  // a sparse file
  if (error) GTEST_SKIP() << "this disk has no sparse files: " << error.message();
  EXPECT_EQ(
      refusal("huge.obj"),
      "huge.obj: is too large (4294967295 bytes; Talus reads up to 4294967294). Cut the mesh to the slope, or use a "
      "raster");
}

TEST_F(MeshFile, RefusesFilesWithoutPermission) {
  std::ofstream{path("secret.obj")} << square_obj;
  std::filesystem::permissions(path("secret.obj"), std::filesystem::perms::none);
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may read everything";
  EXPECT_EQ(refusal("secret.obj"),
            "secret.obj: cannot be read (Permission denied). Paths are relative to the project file");
}

// Random changes, deletions, insertions, repetitions and truncation give a mesh with valid indices, or BadInput.
TEST(MeshFileMutations, GiveAValidMeshOrBadInput) {
  struct Seed {
    RawMesh (*read)(std::string_view, MeshProblems&);
    std::string bytes;
  };
  const std::string obj =
      "# x\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 \\\n0\nv 0.5 0.5 0\nf 1 2 5 3 4\nf -3//1 2/1 1/2/3\n";
  const std::vector<Seed> seeds{{read_obj, obj},
                                {read_stl, text_stl},
                                {read_stl, binary_stl(2, {one_stl_triangle, one_stl_triangle})},
                                {read_ply, text_ply},
                                {read_ply, binary_ply(std::endian::little)},
                                {read_ply, binary_ply(std::endian::big, true)}};
  std::mt19937_64 random{20240229};
  const auto below = [&](std::size_t n) { return static_cast<std::ptrdiff_t>(random() % n); };
  int read = 0;
  int refused = 0;
  for (int trial = 0; trial < 12'000; ++trial) {
    const Seed& seed = seeds[static_cast<std::size_t>(trial) % seeds.size()];
    std::string bytes = seed.bytes;
    for (auto changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) {
      const auto at = bytes.begin() + below(bytes.size());
      switch (below(6)) {
        case 0:
          *at = static_cast<char>(below(256));
          break;
        case 1:
          *at = static_cast<char>('0' + below(10));
          break;
        case 2:
          bytes.erase(at);
          break;
        case 3:
          bytes.insert(at, static_cast<char>(below(256)));
          break;
        case 4:
          bytes.insert(static_cast<std::size_t>(at - bytes.begin()), bytes, 0, static_cast<std::size_t>(below(20)));
          break;
        default:
          bytes.erase(at + below(static_cast<std::size_t>(bytes.end() - at)), bytes.end());
          break;
      }
    }
    MeshProblems problems{"mutated"};
    try {
      const RawMesh mesh = seed.read(bytes, problems);
      ++read;
      EXPECT_FALSE(mesh.triangles.empty());
      for (const Vec3& v : mesh.vertices) EXPECT_TRUE(v.is_finite());
      for (const Corners& t : mesh.triangles) {
        for (const std::uint32_t v : t) EXPECT_LT(v, mesh.vertices.size());
      }
    } catch (const BadInput& error) {
      ++refused;
      EXPECT_THAT(error.what(), ::testing::StartsWith("mutated"));
    }
  }
  // The test is meaningful only if both outcomes are frequent.
  EXPECT_GT(read, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace talus
