#include "talus/import/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "talus/files/file_formats.hpp"
#include "talus/import/mesh_formats.hpp"

namespace talus {
namespace {

static_assert(std::ranges::all_of(file_formats,
                                  [](const FileFormat& format) {
                                    return format.kind != FileKind::mesh ||
                                           std::ranges::find(mesh_formats, format.ending, &MeshFormat::ending) !=
                                               mesh_formats.end();
                                  }),
              "every mesh ending of file_formats.hpp needs a reader in mesh_formats.hpp");

const MeshFormat& mesh_format_of(const std::filesystem::path& path, MeshProblems& problems) {
  const std::string ending = ending_of(path);
  const auto* const found = std::ranges::find(mesh_formats, ending, &MeshFormat::ending);
  if (found != mesh_formats.end()) return *found;
  problems.stop({}, "is not a mesh that Talus can read",
                (ending.empty() ? "its name has no extension" : "its extension is " + in_quotes(ending)) +
                    "; expected " + endings_in_words(FileKind::mesh),
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
  const MeshFormat& format = mesh_format_of(path, problems);
  RawMesh mesh = format.read(read_bytes(path, problems), problems);
  warnings.append(problems.warnings());
  return mesh;
}

RawMesh read_mesh_file(const std::filesystem::path& path) {
  Problems warnings;
  return read_mesh_file(path, warnings);
}

}  // namespace talus
