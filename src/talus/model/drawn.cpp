#include "talus/model/drawn.hpp"

#include <algorithm>
#include <array>

#include "talus/core/check.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

namespace {

constexpr std::array of_material{"normal_restitution", "tangential_restitution", "friction_angle_deg",
                                 "roughness_deg",      "dynamic_friction",       "rolling_friction"};
constexpr std::array of_seeder{"mass_kg",
                               "volume_m3",
                               "diameter_m",
                               "density_kg_m3",
                               "speed_m_s",
                               "horizontal_velocity_m_s",
                               "vertical_velocity_m_s",
                               "rotational_velocity_deg_s"};

}  // namespace

std::optional<Drawn> drawn(std::string_view key, const Distribution& given) {
  // A plain number is the standard deviation of the tilt; a distribution is that of the tilt itself.
  if (key == "roughness_deg" && given.kind == DistributionKind::none && given.mean != 0)
    return Drawn{{0, DistributionKind::normal, given.mean, {}, {}}, {-90, 90}};
  const auto is_in = [key](const auto& keys) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
  if (is_in(of_material)) return Drawn{given, bounds("material", key)};
  if (is_in(of_seeder)) return Drawn{given, bounds("seeder", key)};
  return std::nullopt;
}

Sampler sampler_of(std::string_view key, const Distribution& given, double scale) {
  const auto what = drawn(key, given);
  TALUS_PROMISE(what.has_value(), "the setting is a distribution");
  return Sampler(what->distribution, what->bounds, scale);
}

}  // namespace talus::project
