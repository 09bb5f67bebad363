#include "talus/model/drawn.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "talus/project/settings.hpp"

namespace talus::project {

namespace {

/// The declaration of a random property; null if the key is not one.
const Setting* random_property(std::string_view key) {
  static Material material;  // slots are places in a row
  static Seeder seeder;
  static Shape shape;
  for (const auto& [name, row] :
       {std::pair<const char*, Row>("material", &material), {"seeder", &seeder}, {"shape", &shape}}) {
    const Setting* const setting = table(name).find(key);
    if (setting != nullptr && is_random_property(setting->slot(row))) return setting;
  }
  return nullptr;
}

}  // namespace

std::optional<Drawn> drawn(std::string_view key, const Distribution& given) {
  // A plain number is the standard deviation of the tilt; a distribution is that of the tilt itself.
  if (key == "roughness_deg" && given.kind == DistributionKind::none && given.mean != 0)
    return Drawn{{0, DistributionKind::normal, given.mean, {}, {}}, {-90, 90}};
  const Setting* const setting = random_property(key);
  return setting == nullptr ? std::nullopt : std::optional(Drawn{given, bounds(setting->range)});
}

Sampler sampler_of(std::string_view key, const Distribution& given, double scale) {
  const auto what = drawn(key, given);
  if (!what) throw std::logic_error("no random property " + std::string(key) + " is declared");
  return Sampler(what->distribution, what->bounds, scale);
}

}  // namespace talus::project
