#include "talus/files/file_formats.hpp"

#include <algorithm>
#include <vector>

namespace talus {

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& letter : ending) letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  return ending;
}

const FileFormat* format_of(const std::filesystem::path& file) {
  const auto* const found = std::ranges::find(file_formats, ending_of(file), &FileFormat::ending);
  return found == file_formats.end() ? nullptr : &*found;
}

bool is_of_kind(const std::filesystem::path& file, FileKind kind) {
  const FileFormat* format = format_of(file);
  return format && format->kind == kind;
}

std::string_view name_of(FileKind kind) {
  switch (kind) {
    case FileKind::raster:
      return "raster";
    case FileKind::picture:
      return "picture";
    case FileKind::mesh:
      return "mesh";
    case FileKind::point_text:
    case FileKind::las:
      return "points";
    case FileKind::vector:
      break;
  }
  return "vector";
}

std::string endings_in_words(FileKind kind) {
  std::vector<std::string_view> endings;
  for (const FileFormat& format : file_formats)
    if (format.kind == kind) endings.push_back(format.ending);
  std::string words;
  for (std::size_t i = 0; i < endings.size(); ++i) {
    if (i > 0) words += i + 1 == endings.size() ? " or " : ", ";
    words += endings[i];
  }
  return words;
}

}  // namespace talus
