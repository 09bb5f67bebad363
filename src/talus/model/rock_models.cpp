#include "talus/model/rock_models.hpp"

#include "talus/rocks/heights.hpp"

namespace talus::project {

namespace {

bool is_default(const Distribution& given, const Distribution& usual) {
  return given.kind == DistributionKind::none && given.mean == usual.mean;
}

}  // namespace

std::string_view usual_block(bool is_2d) { return is_2d ? "rectangle_5_6" : "block"; }

Project with_rock_model(const Project& project, RockModel model) {
  Project other = project;
  other.analysis.model = model;
  if (model != RockModel::rigid_body) return other;
  for (Seeder& seeder : other.seeders)
    if (seeder.shape == sphere_word) seeder.shape = usual_block(project.is_2d());
  return other;
}

std::vector<std::string> materials_of_default_friction(const Project& project) {
  const Material usual;
  const Analysis& analysis = project.analysis;
  std::vector<std::string> names;
  for (const Material& material : project.materials) {
    bool has_default = false;
    switch (analysis.model) {
      case RockModel::lumped_mass:
        has_default = analysis.friction_angle == FrictionSource::material &&
                      is_default(material.friction_angle_deg, usual.friction_angle_deg);
        break;
      case RockModel::rigid_sphere:
        has_default = is_default(material.rolling_friction, usual.rolling_friction);
        break;
      case RockModel::rigid_body:
        has_default = is_default(material.dynamic_friction, usual.dynamic_friction);
        break;
    }
    if (has_default) names.push_back(material.name);
  }
  return names;
}

std::string_view name_of(RockModel model) {
  switch (model) {
    case RockModel::lumped_mass:
      return "lumped mass";
    case RockModel::rigid_sphere:
      return "rigid sphere";
    case RockModel::rigid_body:
      return "rigid body";
  }
  return "";
}

}  // namespace talus::project
