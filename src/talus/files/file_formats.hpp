#pragma once
// The endings of the files that Talus reads. Readers, checks, the workbench's list of files and its page use this list.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace talus {

/// A picture is a raster that is drawn only, without elevations.
enum class FileKind { raster, picture, mesh, point_text, las, vector };

struct FileFormat {
  std::string_view ending;  // in lower case
  FileKind kind;
};

inline constexpr std::array file_formats{
    FileFormat{".tif", FileKind::raster},     FileFormat{".tiff", FileKind::raster},
    FileFormat{".asc", FileKind::raster},     FileFormat{".flt", FileKind::raster},
    FileFormat{".bil", FileKind::raster},     FileFormat{".img", FileKind::raster},
    FileFormat{".vrt", FileKind::raster},     FileFormat{".obj", FileKind::mesh},
    FileFormat{".stl", FileKind::mesh},       FileFormat{".ply", FileKind::mesh},
    FileFormat{".csv", FileKind::point_text}, FileFormat{".xyz", FileKind::point_text},
    FileFormat{".txt", FileKind::point_text}, FileFormat{".pts", FileKind::point_text},
    FileFormat{".dat", FileKind::point_text}, FileFormat{".las", FileKind::las},
    FileFormat{".laz", FileKind::las},  // refused with the command that unpacks it
    FileFormat{".dxf", FileKind::vector},     FileFormat{".shp", FileKind::vector},
    FileFormat{".gpkg", FileKind::vector},    FileFormat{".geojson", FileKind::vector},
    FileFormat{".json", FileKind::vector},    FileFormat{".png", FileKind::picture},
    FileFormat{".jpg", FileKind::picture},    FileFormat{".jpeg", FileKind::picture},
};

/// The extension in lower case, with its dot; empty if there is none.
[[nodiscard]] std::string ending_of(const std::filesystem::path& file);

/// The list's entry for a file; null if its ending is not in the list.
[[nodiscard]] const FileFormat* format_of(const std::filesystem::path& file);
[[nodiscard]] bool is_of_kind(const std::filesystem::path& file, FileKind kind);

/// What the workbench calls a kind: "raster", "picture", "mesh", "points" (text and LAS) or "vector".
[[nodiscard]] std::string_view name_of(FileKind kind);

/// For messages: ".obj, .stl or .ply".
[[nodiscard]] std::string endings_in_words(FileKind kind);

}  // namespace talus
