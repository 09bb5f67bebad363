#pragma once
// Whole numbers in as few bytes as they need: seven bits a byte, the lowest first; all bytes but the last have the
// eighth bit set (LEB128).

#include <cstdint>
#include <string>

#include "talus/core/bytes.hpp"

namespace talus {

inline void put_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7U) out.push_back(static_cast<char>(value | 0x80U));
  out.push_back(static_cast<char>(value));
}

[[nodiscard]] inline std::uint64_t get_varint(ByteReader& in) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    const std::uint64_t byte = in.get<std::uint8_t>();
    value |= (byte & 0x7FU) << shift;
    if (byte < 0x80) return value;
  }
  throw BadBytes("a number has too many bytes");
}

}  // namespace talus
