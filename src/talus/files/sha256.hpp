#pragma once
// SHA-256 checksums (FIPS 180-4) of inputs, as printed by sha256sum, `certutil -hashfile FILE SHA256` and
// `Get-FileHash`: anyone can check that a file is the one that was used.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// As 64 hexadecimal digits.
[[nodiscard]] std::string sha256_of(std::string_view bytes);

/// Of the contents of a file; nullopt if it is not an ordinary file, or cannot be read to its end.
[[nodiscard]] std::optional<std::string> sha256_of_file(const std::filesystem::path& file);

}  // namespace talus
