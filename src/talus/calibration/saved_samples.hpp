#pragma once
// The simulated samples of a set as bytes, to be kept on disk.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/calibration/likelihood.hpp"

namespace talus::calibration {

[[nodiscard]] std::string bytes_of(const std::vector<Sample>& samples);
/// Nullopt if the bytes cannot be those of samples.
[[nodiscard]] std::optional<std::vector<Sample>> samples_in(std::string_view bytes);

}  // namespace talus::calibration
