#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/forest_words.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> library_slot() {
  return [](const Row& row) -> Slot { return LibrarySlot{&row.as<Material>()}; };
}

}  // namespace

Table material_table() {
  return {
      .key = "material",
      .repeated = true,
      .required = true,
      .meaning = "A kind of ground; one entry for each.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Material::name),
               .required = true,
               .meaning = "Name that `[ground]` refers to; must be unique.",
               .source = "Talus"},
              {.key = "like",
               .slot = library_slot(),
               .without_it = "the defaults below apply",
               .title = "Library material",
               .topic = topics::library,
               .meaning = "A material of the library (docs/materials.md, `talus materials`); its values apply where "
                          "this entry gives none.",
               .source = "the publications named in the library"},
              {.key = "normal_restitution",
               .slot = member(&Material::normal_restitution),
               .range = restitution,
               .group = "Impact",
               .meaning = "Rn, the part of the velocity normal to the ground that an impact returns.",
               .source = "the form: the manual, table 1-2; the default: Talus",
               .slip = restitution_slip},
              {.key = "tangential_restitution",
               .slot = member(&Material::tangential_restitution),
               .range = restitution,
               .group = "Impact",
               .meaning = "Rt, the part of the velocity along the ground that remains after an impact; for a rigid "
                          "sphere, of the velocity of its contact point, as far as friction allows (docs/laws.md).",
               .source = "the form: the manual, table 1-2; the default: Talus",
               .slip = restitution_slip},
              {.key = "friction_angle_deg",
               .slot = member(&Material::friction_angle_deg),
               .unit = "deg",
               .range = {.least = 0,
                         .most = 89.9,  // tan(90) is infinite, and draws stay within this range
                         .too_low = "friction cannot push",
                         .too_high = "no rock would slide"},
               .applies_when = {of_model(RockModel::lumped_mass, Otherwise::kept)},
               .group = "Sliding and rolling",
               .meaning = "phi, the friction angle of sliding.",
               .source = "the manual, table 1-2",
               .doubt = radians_doubt},
              {.key = "roughness_deg",
               .slot = member(&Material::roughness_deg),
               .unit = "deg",
               .range =
                   {.least = 0, .most = 90, .most_excluded = true, .limits_draws = false},  // tilts have both signs
               .group = "Impact",
               .topic = topics::rough_ground,
               .meaning = "Tilt of the small faces of the ground against the slope: a plain number is the standard "
                          "deviation of a normal distribution about 0; 0 is smooth.",
               .source = "RocFall: slope roughness"},
              {.key = "roughness_spacing_m",
               .slot = member(&Material::roughness_spacing_m),
               .unit = "m",
               .range = up_to(most_diameter_m),
               .group = "Impact",
               .topic = topics::rough_ground,
               .meaning =
                   "Mean distance between the bumps that a rock meets as it slides or rolls over rough ground, and "
                   "distance of the points to which `roughness_amplitude_m` refers; 0: no bumps.",
               .source = "Talus, on which results hardly depend; with an amplitude, RocFall: slope roughness"},
              {.key = "roughness_amplitude_m",
               .slot = member(&Material::roughness_amplitude_m),
               .unit = "m",
               .range = up_to(most_diameter_m),
               .group = "Impact",
               .topic = topics::rough_ground,
               .meaning =
                   "Standard deviation of the heights of rough ground at points `roughness_spacing_m` apart, from "
                   "which the tilts of its faces follow; in place of `roughness_deg`. With the laws of RocFall, "
                   "of rigid spheres only, and in addition to `roughness_deg`.",
               .source = "RocFall: slope roughness"},
              {.key = "dynamic_friction",
               .slot = member(&Material::dynamic_friction),
               .range = up_to(most_factor, "friction cannot push"),
               .applies_when = {of_rigid_rocks(Otherwise::kept)},
               .group = "Sliding and rolling",
               .topic = topics::laws,
               .meaning = "mu, the coefficient of friction while the contact slips.",
               .source = "the manual, section 7; the default: Talus"},
              {.key = "rolling_friction",
               .slot = member(&Material::rolling_friction),
               .range = up_to(most_factor, "friction cannot push"),
               .applies_when = {of_rigid_rocks(Otherwise::kept)},
               .group = "Sliding and rolling",
               .topic = topics::laws,
               .meaning = "mu_r, the moment that resists rolling, divided by weight and radius.",
               .source = "RocFall; the default: Talus"},
              {.key = "forest",
               .slot = member(&Material::forest),
               .group = "Forest",
               .topic = topics::forest,
               .meaning = "Density of the forest on this ground: the drag is 250 kg/s for `open`, 500 kg/s for "
                          "`medium`, 750 kg/s for `dense`.",
               .source = forest_words::density_source},
              {.key = "forest_drag_kg_s",
               .slot = member(&Material::forest_drag_kg_s),
               .unit = "kg/s",
               .range = forest_words::drag_range(),
               .without_it = "given by `forest`",
               .group = "Forest",
               .topic = topics::forest,
               .meaning = forest_words::drag_meaning,
               .source = forest_words::drag_source},
              {.key = "forest_height_m",
               .slot = member(&Material::forest_height_m),
               .unit = "m",
               .range = forest_words::height_range(),
               .without_it = "required with `forest` or `forest_drag_kg_s`",
               .applies_when = {{.any_of = {is_not("forest", {word(Forest::none)}), given("forest_drag_kg_s")},
                                 .why = "there is no forest",
                                 .hint = "Write forest = \"medium\", or give forest_drag_kg_s"}},
               .group = "Forest",
               .topic = topics::forest,
               .meaning = forest_words::height_meaning,
               .source = forest_words::height_source},
              {.key = "ground_drag_per_s",
               .slot = member(&Material::ground_drag_per_s),
               .unit = "1/s",
               .range = up_to(most_factor, "ground cannot push"),
               .group = "Sliding and rolling",
               .topic = topics::soft_ground,
               .meaning = "Viscoplastic drag of soft ground: in addition to friction, a sliding or rolling rock is "
                          "decelerated by this times its velocity.",
               .source = "RAMMS::ROCKFALL (Bartelt et al. 2016): 0.3 on bedrock to 0.9 on a moor, see docs/laws.md"},
              {.key = "max_friction",
               .slot = member(&Material::max_friction),
               .range = up_to(most_factor, "friction cannot push"),
               .without_it = "friction does not depend on the way slid",
               .applies_when = {of_model(RockModel::rigid_body, Otherwise::warned),
                                together_with({given("friction_rise_per_m")}),
                                together_with({given("friction_decay_per_s")})},
               .group = "Sliding and rolling",
               .topic = topics::laws,
               .meaning = "Friction of blocks that rises with the way s that they slide: from dynamic_friction it "
                          "comes near to this.",
               .source = "Leine et al. 2014, equations 46 and 47"},
              {.key = "friction_rise_per_m",
               .slot = member(&Material::friction_rise_per_m),
               .unit = "1/m",
               .range = above_0_up_to(most_factor, "friction rises with the way slid"),
               .without_it = "friction does not depend on the way slid",
               .applies_when = {of_model(RockModel::rigid_body, Otherwise::warned),
                                together_with({given("max_friction")}), together_with({given("friction_decay_per_s")})},
               .group = "Sliding and rolling",
               .topic = topics::laws,
               .meaning = "kappa of that rise, 2/pi atan(kappa s).",
               .source = "Leine et al. 2014, equations 46 and 47"},
              {.key = "friction_decay_per_s",
               .slot = member(&Material::friction_decay_per_s),
               .unit = "1/s",
               .range = up_to(most_factor, "friction does not rise in the air"),
               .without_it = "friction does not depend on the way slid",
               .applies_when = {of_model(RockModel::rigid_body, Otherwise::warned),
                                together_with({given("max_friction")}), together_with({given("friction_rise_per_m")})},
               .group = "Sliding and rolling",
               .topic = topics::laws,
               .meaning = "beta: in the air s fades as exp(-beta t).",
               .source = "Leine et al. 2014, equations 46 and 47"},
          },
      .choices = {{{"forest"}, {"forest_drag_kg_s"}}},
      .groups = {{""}, {"Impact"}, {"Sliding and rolling"}, {"Forest", true}},
      .topic = topics::equations,
      .add = [](Project& project) { return added(project.materials); },
      .rows = [](Project& project) { return all(project.materials); },
  };
}

}  // namespace talus::project::declared
