#pragma once
// Base64 (RFC 4648), for data within pages.

#include <cstdint>
#include <span>
#include <string>

namespace talus {

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace talus
