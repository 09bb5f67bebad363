#pragma once
// Pictures from outside that a page contains: PNG and JPEG. SVG is refused, because it can contain scripts and refer to
// other files.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace talus {

inline constexpr std::uintmax_t most_picture_bytes = 512 * 1024;
inline constexpr std::uint32_t most_picture_pixels = 4000;  // a side: a browser unpacks the whole picture

struct Picture {
  std::string_view media_type;  // "image/png" or "image/jpeg"
  std::uint32_t width = 0, height = 0;
};

/// What the bytes are, from the headers of PNG (ISO/IEC 15948, 11.2.2) and JPEG (ITU-T T.81, B.2.2). Throws BadBytes if
/// they are neither, have no size, or are too many pixels.
[[nodiscard]] Picture picture_in(std::string_view bytes);

/// The picture in a file as a `data:` address for pages. Throws BadBytes with the reason if the file is no such
/// picture, is too large, or cannot be read.
[[nodiscard]] std::string data_address_of_picture(const std::filesystem::path& file);

}  // namespace talus
