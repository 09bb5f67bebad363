#include "talus/project/settings/limits.hpp"

#include <fmt/format.h>

#include <numbers>

namespace talus::project::declared {

std::optional<double> restitution_slip(double value) {
  if (value > 1 && value < 10) return value / 10;
  if (value >= 10 && value <= 100) return value / 100;
  return std::nullopt;
}

std::optional<double> sign_slip(double value) { return value < 0 ? std::optional(-value) : std::nullopt; }

std::optional<double> density_slip(double value) {
  return value >= 0.5 && value <= 20 ? std::optional(value * 1000) : std::nullopt;
}

std::optional<Doubt> radians_doubt(double value) {
  if (value <= 0 || value > std::numbers::pi / 2) return std::nullopt;
  return Doubt{"angles are in degrees, and this ground would be almost frictionless",
               fmt::format("If it is in radians, write {:.4g}", value * 180 / std::numbers::pi)};
}

std::optional<Doubt> tonnes_doubt(double value) {
  constexpr double pebble = 5;  // kg
  if (value > pebble) return std::nullopt;
  return Doubt{"masses are in kilograms, and this stone would fit in a hand",
               fmt::format("If it is in tonnes, write {}", value * 1000)};
}

std::function<std::optional<Doubt>(double)> beyond(double usual, std::string why, std::string hint) {
  return [=](double value) { return value > usual ? std::optional(Doubt{why, hint}) : std::nullopt; };
}

std::optional<Doubt> mass_doubt(double value) {
  constexpr double usual_kg = 1.2e7;  // of the largest block
  if (const auto hand = tonnes_doubt(value)) return hand;
  return beyond(usual_kg, beyond_blocks, "mass_kg is in kilograms")(value);
}

std::optional<double> percent_slip(double value) {
  return value > 1 && value < 100 ? std::optional(value / 100) : std::nullopt;
}

}  // namespace talus::project::declared
