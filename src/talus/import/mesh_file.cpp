#include "talus/import/mesh_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "talus/import/mesh_formats.hpp"
#include "talus/import/mesh_text.hpp"

namespace talus {
namespace {

using Reader = RawMesh (*)(std::string_view, MeshProblems&);

Reader reader_for(const std::filesystem::path& path, MeshProblems& problems) {
  const std::string ending = lower(path.extension().string());
  if (ending == ".obj") return read_obj;
  if (ending == ".stl") return read_stl;
  if (ending == ".ply") return read_ply;
  problems.stop({}, "is not a mesh that Talus can read",
                (ending.empty() ? "its name has no extension" : "its extension is " + in_quotes(ending)) +
                    "; expected .obj, .stl or .ply",
                "Convert it, or give the file the extension of its format");
}

std::string read_bytes(const std::filesystem::path& path, MeshProblems& problems) {
  const auto refuse = [&](const std::error_code& error) {
    problems.stop({}, "cannot be read", error.message(), "Paths are relative to the project file");
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error) refuse(error);
  if (std::filesystem::is_directory(status)) problems.stop({}, "cannot be read", "it is a folder", "Name a file");
  if (!std::filesystem::is_regular_file(status)) problems.stop({}, "cannot be read", "it is not an ordinary file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuse(error);
  if (size == 0) problems.stop({}, "is empty", "it has no bytes");
  if (size >= largest_mesh_file_bytes) {
    problems.stop({}, "is too large", fmt::format("{} bytes; Talus reads up to {}", size, largest_mesh_file_bytes - 1),
                  "Cut the mesh to the slope, or use a raster");
  }
  errno = 0;
  std::ifstream stream{path, std::ios::binary};
  if (!stream) refuse(std::error_code{errno, std::generic_category()});
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (stream.gcount() != static_cast<std::streamsize>(size)) {
    problems.stop({}, "cannot be read completely",
                  fmt::format("only {} of {} bytes could be read", stream.gcount(), size));
  }
  return bytes;
}

}  // namespace

RawMesh read_mesh_file(const std::filesystem::path& path, Problems& warnings) {
  MeshProblems problems{path.string()};
  const Reader read = reader_for(path, problems);
  RawMesh mesh = read(read_bytes(path, problems), problems);
  warnings.append(problems.warnings());
  return mesh;
}

RawMesh read_mesh_file(const std::filesystem::path& path) {
  Problems warnings;
  return read_mesh_file(path, warnings);
}

}  // namespace talus
