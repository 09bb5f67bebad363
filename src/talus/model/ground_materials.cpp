#include "talus/model/ground_materials.hpp"

#include <fmt/format.h>

#include "talus/core/degrees.hpp"
#include "talus/model/drawn.hpp"

namespace talus::project {

namespace {

talus::Material material_of(const Material& m, const Analysis& a) {
  talus::Material material;
  material.name = m.name;
  material.normal_restitution = sampler_of("normal_restitution", m.normal_restitution);
  material.tangential_restitution = sampler_of("tangential_restitution", m.tangential_restitution);
  material.friction_angle = sampler_of("friction_angle_deg", m.friction_angle_deg, radians);
  material.roughness = RoughGround(sampler_of("roughness_deg", m.roughness_deg, radians), m.roughness_spacing_m,
                                   a.has_heights_of_roughness() ? m.roughness_amplitude_m : 0);
  material.dynamic_friction = sampler_of("dynamic_friction", m.dynamic_friction);
  material.rolling_friction = sampler_of("rolling_friction", m.rolling_friction);
  material.forest_drag = m.forest_drag();
  material.forest_height = m.forest_height_m.value_or(0);
  material.ground_drag = m.ground_drag_per_s;
  if (m.max_friction && m.friction_rise_per_m && m.friction_decay_per_s)
    material.friction_rise = {*m.max_friction, *m.friction_rise_per_m, *m.friction_decay_per_s};
  return material;
}

}  // namespace

std::vector<talus::Material> materials_of(const Project& project, std::span<const LaidForest> laid) {
  std::vector<talus::Material> materials;
  for (const Material& material : project.materials) materials.push_back(material_of(material, project.analysis));
  for (const LaidForest& each : laid) {
    const ForestArea& forest = project.forests[each.forest];
    talus::Material material = materials[each.material];
    material.name += fmt::format(", in {}", forest.name);
    material.forest_drag = forest.drag();
    material.forest_height = forest.height_m.value_or(0);
    material.laid_forest = each;
    materials.push_back(std::move(material));
  }
  return materials;
}

}  // namespace talus::project
