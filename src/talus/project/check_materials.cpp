#include "talus/project/check_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "talus/project/material_library.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {
namespace {

/// The slope on which the friction holds back gravity [deg].
double slope_of(double friction) { return std::atan(friction) * 180 / std::numbers::pi; }

/// Whether the file or the library gives a value.
bool gives(const toml::table& row, const Material& material, std::string_view key) {
  const LibraryMaterial* entry = material_library().find(material.like);
  return row.contains(key) || (entry && entry->find(key));
}

bool has_tilt(const Material& material) {
  return material.roughness_deg.mean > 0 || material.roughness_deg.kind != DistributionKind::none;
}

bool is_rough(const Material& material) {
  return has_tilt(material) || (material.roughness_amplitude_m > 0 && material.roughness_spacing_m > 0);
}

}  // namespace

void MaterialRules::check() const {
  for (std::size_t i = 0; i < rows.size() && i < project.materials.size(); ++i) {
    if (!rows[i]) continue;
    const std::string where = name_of_row(table("material"), *rows[i], i);
    check_forest(project.materials[i], *rows[i], where);
    if (project.analysis.roughness == RoughnessLaw::faces) check_faces(project.materials[i], *rows[i], where);
    if (project.analysis.model == RockModel::rigid_sphere) check_sphere(project.materials[i], *rows[i], where);
    if (project.analysis.model == RockModel::rigid_body) check_body(project.materials[i], *rows[i], where);
  }
  check_roughness();
}

void MaterialRules::check_forest(const Material& material, const toml::table& row, const std::string& where) const {
  const bool has_forest = material.forest != Forest::none || material.forest_drag_kg_s;
  if (!has_forest || row.contains("forest_height_m")) return;
  const toml::node* forest = row.get(material.forest_drag_kg_s ? "forest_drag_kg_s" : "forest");
  report({forest, &row, "forest_height_m"}, where, "forest_height_m is missing",
         "a forest slows rocks only up to its effective height",
         "Give the height above the ground up to which trunks and branches slow rocks", Severity::error);
}

/// The tilts of faces are given in one way.
void MaterialRules::check_faces(const Material& material, const toml::table& row, const std::string& where) const {
  if (!has_tilt(material) || !(material.roughness_amplitude_m > 0)) return;
  const toml::node* amplitude = row.get("roughness_amplitude_m");
  report({amplitude, &row, "roughness_amplitude_m"}, where, "roughness_amplitude_m is given beside roughness_deg",
         "both say how the faces of the ground are tilted",
         "Give one of them, or roughness_law = \"tilts\" in [analysis], which adds them as RocFall does",
         Severity::error);
}

void MaterialRules::check_sphere(const Material& material, const toml::table& row, const std::string& where) const {
  const double rolling = material.rolling_friction.mean;
  const double dynamic = material.dynamic_friction.mean;
  if (!gives(row, material, "rolling_friction")) {
    const toml::node* like = accepted(&row, "like");
    if (row.contains("like") && !like) return;  // refused
    report({like ? like : &row, &row, "rolling_friction"}, where, "rolling_friction is not given",
           fmt::format("{}the default {:g} brings spheres to rest only on slopes of less than {:.1f} degrees",
                       like ? fmt::format("the library has none for \"{}\", and ", material.like) : "", rolling,
                       slope_of(rolling)),
           "Give the tangent of the slope on which such rocks keep rolling (docs/laws.md, values of spheres), or like "
           "= a ground that has one (talus materials)",
           Severity::warning);
    return;
  }
  const toml::node* given = row.get("rolling_friction");
  const Spot at = given ? Spot(given) : Spot(&row, &row, "rolling_friction");
  if (rolling > dynamic) {
    report(
        at, where,
        fmt::format("rolling_friction is {}, but dynamic_friction only {}", number_text(rolling), number_text(dynamic)),
        fmt::format("a sphere skids before it resists like that, and comes to rest only on slopes of less than "
                    "{:.1f} degrees instead of {:.1f}",
                    slope_of(dynamic), slope_of(rolling)),
        fmt::format("Give dynamic_friction = {} or more", number_text(rolling)), Severity::warning);
  } else if (is_measured && rolling == 0 && material.rolling_friction.kind == DistributionKind::none) {
    report(at, where, "rolling_friction is 0", "a sphere on it rolls until it leaves the model or lies in a pit",
           "Give the tangent of the slope on which such rocks keep rolling (docs/laws.md, values of spheres)",
           Severity::warning);
  }
}

/// Beyond these, restitution of eccentric contacts with friction can create energy: Rn^2 G_nn (G^-1)_nn, with G the
/// inverse mass of the contact, exceeds 1 for some blocks in some postures.
void MaterialRules::check_body(const Material& material, const toml::table& row, const std::string& where) const {
  if (material.max_friction && *material.max_friction < material.dynamic_friction.mean) {
    report({row.get("max_friction"), &row, "max_friction"}, where,
           fmt::format("max_friction is {}, but dynamic_friction {}", number_text(*material.max_friction),
                       number_text(material.dynamic_friction.mean)),
           "friction rises from dynamic_friction to max_friction", "Give more than dynamic_friction", Severity::error);
  }
  constexpr double max_restitution = 0.67, low_friction = 0.2;
  const double rn = material.normal_restitution.mean;
  if (!(rn > max_restitution) || !(material.dynamic_friction.mean > low_friction)) return;
  const toml::node* given = row.get("normal_restitution");
  report(given ? Spot(given) : Spot(&row, &row, "normal_restitution"), where,
         fmt::format("normal_restitution is {}", number_text(rn)),
         fmt::format("above {:g} an impact of a block with friction could create energy, and then has less restitution",
                     max_restitution),
         "Give what was observed of blocks: 0.2 to 0.5 on most ground (docs/shapes.md)", Severity::warning);
}

void MaterialRules::check_roughness() const {
  if (!is_measured || rows.empty() || !rows.front()) return;
  if (std::ranges::any_of(project.materials, is_rough)) return;
  constexpr std::int64_t many = 100;  // enough that the user expects a spread
  const bool has_many = std::ranges::any_of(
      project.seeders, [](const Seeder& seeder) { return seeder.is_of_cells() || seeder.rocks >= many; });
  if (!has_many) return;
  for (const toml::table* row : rows) {
    if (row && row->contains("roughness_deg") && !accepted(row, "roughness_deg")) return;  // refused
    if (row && row->contains("like") && !accepted(row, "like")) return;
  }
  report({rows.front(), rows.front(), "roughness_deg"}, "",
         project.materials.size() == 1 ? "the material has no roughness" : "no material has a roughness",
         "on terrain in 3D all rocks from one place then follow almost the same path: nothing turns them aside",
         "Give roughness_deg (docs/laws.md, values of roughness), or like = a ground that has one (talus materials)",
         Severity::warning);
}

}  // namespace talus::project
