#pragma once
// Pictures as bytes.

#include <cstdint>
#include <string>

namespace talus::testing_tools {

inline std::string big_endian(std::uint32_t number, int bytes) {
  std::string text;
  for (int k = bytes - 1; k >= 0; --k) text += static_cast<char>(number >> (8 * k) & 0xffU);
  return text;
}

/// CRC of ISO 3309, as in the PNG specification.
inline std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) crc = (crc & 1U) != 0 ? 0xedb88320U ^ crc >> 1U : crc >> 1U;
  }
  return crc ^ 0xffffffffU;
}

inline std::string png_chunk(const std::string& name, const std::string& content) {
  return big_endian(static_cast<std::uint32_t>(content.size()), 4) + name + content +
         big_endian(crc_of(name + content), 4);
}

/// A grey PNG whose pixels are stored without compression if there are few, and left out otherwise.
inline std::string small_png(std::uint32_t width, std::uint32_t height) {
  std::string pixels;
  if (std::uint64_t{width} * height < 60'000) {
    for (std::uint32_t row = 0; row < height; ++row) pixels += std::string(1, '\0') + std::string(width, '\x60');
  }
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : pixels) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto little = [](std::size_t number) {
    return std::string{static_cast<char>(number & 0xffU), static_cast<char>(number >> 8U & 0xffU)};
  };
  const std::string stored = std::string("\x78\x01\x01", 3) + little(pixels.size()) + little(~pixels.size()) + pixels +
                             big_endian(b << 16U | a, 4);
  const std::string header = big_endian(width, 4) + big_endian(height, 4) + std::string("\x08\0\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", stored) + png_chunk("IEND", "");
}

/// A JPEG up to the header of its frame, with a fill byte before it.
inline std::string jpeg_head(std::uint32_t width, std::uint32_t height) {
  return std::string("\xff\xd8\xff\xe0\0\x10JFIF\0\1\1\0\0\1\0\1\0\0", 20) + std::string("\xff\xff\xc0\0\x0b\x08", 6) +
         big_endian(height, 2) + big_endian(width, 2) + std::string("\1\1\x11\0\xff\xd9", 6);
}

}  // namespace talus::testing_tools
