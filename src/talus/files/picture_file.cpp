#include "talus/files/picture_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>

#include "talus/core/bytes.hpp"
#include "talus/files/base64.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus {

namespace {

/// Big-endian.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t length) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < length; ++k) number = number << 8U | static_cast<std::uint8_t>(bytes[at + k]);
  return number;
}

Picture png_in(std::string_view bytes) {
  expect_bytes(bytes.size() >= 24 && bytes.substr(12, 4) == "IHDR", "the PNG picture is damaged");
  return {"image/png", number_at(bytes, 16, 4), number_at(bytes, 20, 4)};
}

/// The size is in the first segment that begins a frame: SOF0 to SOF15 without DHT, JPG and DAC.
Picture jpeg_in(std::string_view bytes) {
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    expect_bytes(bytes[at] == '\xff', "the JPEG picture is damaged");
    const std::uint32_t marker = number_at(bytes, at + 1, 1);
    if (marker == 0xff) {  // a fill byte
      ++at;
      continue;
    }
    if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) {
      expect_bytes(at + 9 <= bytes.size(), "the JPEG picture is damaged");
      return {"image/jpeg", number_at(bytes, at + 7, 2), number_at(bytes, at + 5, 2)};
    }
    const std::size_t length = number_at(bytes, at + 2, 2);
    expect_bytes(length >= 2, "the JPEG picture is damaged");
    at += 2 + length;
  }
  throw BadBytes("the JPEG picture is damaged");
}

}  // namespace

Picture picture_in(std::string_view bytes) {
  Picture picture;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) {
    picture = png_in(bytes);
  } else if (bytes.starts_with("\xff\xd8\xff")) {
    picture = jpeg_in(bytes);
  } else {
    throw BadBytes("it is neither a PNG nor a JPEG picture");
  }
  expect_bytes(picture.width > 0 && picture.height > 0, "the picture has no pixels");
  if (picture.width > most_picture_pixels || picture.height > most_picture_pixels) {
    throw BadBytes(fmt::format("it has {} x {} pixels; expected at most {} a side", picture.width, picture.height,
                               most_picture_pixels));
  }
  return picture;
}

std::string data_address_of_picture(const std::filesystem::path& file) {
  if (const auto why = not_an_ordinary_file(file)) throw BadBytes(*why);
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadBytes(std::strerror(errno));
  std::string bytes(most_picture_bytes + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad()) throw BadBytes("it cannot be read to its end");
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.size() > most_picture_bytes) {
    throw BadBytes(fmt::format("it is larger than {} kB", most_picture_bytes / 1024));
  }
  const Picture picture = picture_in(bytes);
  const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return fmt::format("data:{};base64,{}", picture.media_type, base64(std::span(first, bytes.size())));
}

}  // namespace talus
