#include "talus/project/drawn.hpp"

#include <algorithm>
#include <array>

#include "talus/core/check.hpp"

namespace talus::project {

namespace {

constexpr Bounds share{0, 1};
constexpr Bounds not_negative{0, 1e300};
constexpr Bounds positive{1e-300, 1e300};

struct Bounded {
  std::string_view key;
  Bounds bounds;
};
constexpr std::array bounded{Bounded{"normal_restitution", share},
                             Bounded{"tangential_restitution", share},
                             Bounded{"friction_angle_deg", {0, 89.9}},
                             Bounded{"roughness_deg", {}},
                             Bounded{"dynamic_friction", not_negative},
                             Bounded{"rolling_friction", not_negative},
                             Bounded{"mass_kg", positive},
                             Bounded{"volume_m3", positive},
                             Bounded{"diameter_m", positive},
                             Bounded{"density_kg_m3", positive},
                             Bounded{"speed_m_s", not_negative},
                             Bounded{"horizontal_velocity_m_s", {}},
                             Bounded{"vertical_velocity_m_s", {}},
                             Bounded{"rotational_velocity_deg_s", {}}};

}  // namespace

std::optional<Drawn> drawn(std::string_view key, const Distribution& given) {
  // A plain number of degrees is the standard deviation of the tilt; a distribution is that of the tilt itself.
  if (key == "roughness_deg" && given.kind == DistributionKind::none && given.mean != 0)
    return Drawn{{0, DistributionKind::normal, given.mean, {}, {}}, {-90, 90}};
  const auto found = std::find_if(bounded.begin(), bounded.end(), [&](const Bounded& each) { return each.key == key; });
  return found == bounded.end() ? std::nullopt : std::optional(Drawn{given, found->bounds});
}

Sampler sampler_of(std::string_view key, const Distribution& given, double scale) {
  const auto what = drawn(key, given);
  TALUS_PROMISE(what.has_value(), "only settings that are distributions are asked for");
  return Sampler(what->distribution, what->bounds, scale);
}

}  // namespace talus::project
