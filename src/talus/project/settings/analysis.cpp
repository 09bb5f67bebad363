#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> laws_slot() {
  return [](const Row& row) -> Slot { return LawsSlot{&row.as<Analysis>()}; };
}

}  // namespace

Table analysis_table() {
  auto [add, rows] = one_row(&Project::analysis);
  return {
      .key = "analysis",
      .meaning = "How rocks move.",
      .settings =
          {
              {.key = "laws",
               .slot = laws_slot(),
               .group = "Motion",
               .topic = topics::law_sets,
               .meaning = "Whose laws rocks obey: those of Talus, or those of RocFall2 and RocFall3 as their published "
                          "tables need them. It chooses the defaults of the other keys of this table, each of which "
                          "may still be given.",
               .source = "Talus; the manual"},
              {.key = "model",
               .slot = member(&Analysis::model),
               .title = "Rock model",
               .group = "Motion",
               .topic = topics::which_model,
               .meaning = "A rock is a point with mass and spin (`lumped_mass`, the law of CRSP), a sphere with a "
                          "radius (`rigid_sphere`), or a block with the shape of its seeder (`rigid_body`). Results "
                          "may differ by more than by any value of the ground: run all three.",
               .source = "the manual, sections 2 and 7"},
              {.key = "rotation",
               .slot = member(&Analysis::rotation),
               .applies_when = {of_model(RockModel::lumped_mass, Otherwise::warned)},
               .always_accepted = {"true"},
               .group = "Motion",
               .meaning = "impacts couple spin and velocity; without it, they follow plain restitution.",
               .source = "RocFall: \"consider rotational velocity\""},
              {.key = "gravity_m_s2",
               .slot = member(&Analysis::gravity_m_s2),
               .unit = "m/s2",
               .range = {.least = least_gravity_m_s2,
                         .most = most_gravity_m_s2,
                         .too_low = "gravity is a magnitude and always points down"},
               .group = "Motion",
               .meaning = "Acceleration of gravity.",
               .source = "standard gravity, as in the tables of RocFall2 and RocFall3; the manual's hand calculations "
                         "use 9.81",
               .slip = sign_slip},
              {.key = "sliding",
               .slot = member(&Analysis::sliding),
               .applies_when = {of_model(RockModel::lumped_mass, Otherwise::warned)},
               .always_accepted = {word(SlidingMethod::stepped)},
               .group = "Motion",
               .meaning = "sliding is integrated in time steps, as in RocFall3 (`stepped`), or solved exactly facet by "
                          "facet, as in RocFall2 (`closed_form`).",
               .source = "the manual, section 3"},
              {.key = "max_timestep_s",
               .slot = member(&Analysis::max_timestep_s),
               .unit = "s",
               .range = {.least = 1e-4, .most = most_time_s, .too_low = "one slide would take billions of such steps"},
               .title = "Time step",
               .group = "When a rock stops",
               .meaning = "Time step of stepped sliding and of rolling.",
               .source = "RocFall3"},
              {.key = "normal_velocity_cutoff_m_s",
               .slot = member(&Analysis::normal_velocity_cutoff_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s),
               .group = "When a rock stops",
               .topic = topics::points,
               .meaning = "A rock that leaves an impact with a lower normal velocity than this stays on the ground and "
                          "slides or rolls.",
               .source = "RocFall2 and RocFall3"},
              {.key = "grazing_angle_deg",
               .slot = member(&Analysis::grazing_angle_deg),
               .unit = "deg",
               .range = up_to(45),
               .group = "When a rock stops",
               .topic = topics::points,
               .meaning =
                   "A rock that slides or rolls, and meets ground at a smaller angle than this at a bend or after a "
                   "hop over one, moves on along it without an impact, slowed by friction. With the default, "
                   "results hardly depend on the size of cells; with 0 every bend is an impact, as in RocFall.",
               .source = "Talus; 0 in RocFall2 and RocFall3"},
              {.key = "stopped_velocity_m_s",
               .slot = member(&Analysis::stopped_velocity_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s),
               .group = "When a rock stops",
               .topic = topics::points,
               .meaning = "A rock slower than this comes to rest where friction can hold it.",
               .source = "RocFall2 and RocFall3"},
              {.key = "max_steps",
               .slot = member(&Analysis::max_steps),
               .range = between(1, 1e9),
               .title = "Maximum steps",
               .group = "When a rock stops",
               .meaning = "A trajectory with more steps than this (flights, impacts and stretches along the ground, "
                          "counted together) ends, for the reason \"maximum steps\".",
               .source = "Talus"},
              {.key = "max_time_s",
               .slot = member(&Analysis::max_time_s),
               .unit = "s",
               .range = above_0_up_to(most_time_s),
               .title = "Maximum time",
               .group = "When a rock stops",
               .meaning = "A trajectory that lasts longer than this ends, for the reason \"maximum time\".",
               .source = "Talus"},
              {.key = "energy_datum_m",
               .slot = member(&Analysis::energy_datum_m),
               .unit = "m",
               .range = place,
               .without_it = "the lowest point of the terrain",
               .group = "Motion",
               .meaning = "Elevation at which potential energy is zero.",
               .source = "the manual: 0 in sections 2, 3 and 7, the lowest vertex in sections 1 and 6"},
              {.key = "friction_angle",
               .slot = member(&Analysis::friction_angle),
               .applies_when = {of_model(RockModel::lumped_mass, Otherwise::warned)},
               .always_accepted = {word(FrictionSource::material)},
               .group = "Motion",
               .topic = topics::points,
               .meaning = "the friction angle of sliding is the material's, follows from its tangential restitution as "
                          "phi = arctan((1 - Rt) / Rt), or is zero.",
               .source = "RocFall"},
              {.key = "roughness_law",
               .slot = member(&Analysis::roughness),
               .group = "Motion",
               .topic = topics::rough_ground,
               .meaning =
                   "A rock meets the faces of rough ground by the area that they show it, in impacts and at bumps "
                   "along the ground (`faces`); or the ground is tilted by a random angle in impacts only "
                   "(`tilts`).",
               .source = "Talus; `tilts`: RocFall2 and RocFall3"},
              {.key = "scale_rn_by_velocity",
               .slot = member(&Analysis::scale_rn_by_velocity),
               .title = "Scale Rn by velocity",
               .group = "Restitution",
               .meaning = "Faster impacts rebound less: Rn / (1 + (vn / K)^2), where K is `rn_velocity_scale_m_s`.",
               .source = "Pfeiffer and Bowen 1989 (CRSP); false in the tables of RocFall2 and RocFall3"},
              {.key = "rn_velocity_scale_m_s",
               .slot = member(&Analysis::rn_velocity_scale_m_s),
               .unit = "m/s",
               .range = above_0_up_to(most_speed_m_s),
               .applies_when = {{.any_of = {is("scale_rn_by_velocity", {"true"})}}},
               .title = "Velocity scale of Rn",
               .group = "Restitution",
               .meaning = "Normal velocity at which scaling by velocity halves the normal restitution.",
               .source = "30 ft/s, Pfeiffer and Bowen 1989 (CRSP)"},
              {.key = "scale_rn_by_mass",
               .slot = member(&Analysis::scale_rn_by_mass),
               .title = "Scale Rn by mass",
               .group = "Restitution",
               .meaning = "Heavier rocks rebound less: Rn / (1 + (m / K)^2), where K is `rn_mass_scale_kg`.",
               .source = "RocFall"},
              {.key = "rn_mass_scale_kg",
               .slot = member(&Analysis::rn_mass_scale_kg),
               .unit = "kg",
               .range = above_0_up_to(most_mass_kg),
               .applies_when = {{.any_of = {is("scale_rn_by_mass", {"true"})}}},
               .title = "Mass scale of Rn",
               .group = "Restitution",
               .meaning = "Mass at which scaling by mass halves the normal restitution.",
               .source = "RocFall"},
              {.key = "tangential_crsp_damping",
               .slot = member(&Analysis::tangential_crsp_damping),
               .applies_when = {of_rigid_rocks(Otherwise::kept)},
               .title = "Tangential CRSP damping",
               .group = "Restitution",
               .meaning = "the tangential velocity of a sphere after an impact is damped as in CRSP.",
               .source = "RocFall3, where it is an option; false in its tables"},
              {.key = "rolling_resistance_in_impacts",
               .slot = member(&Analysis::rolling_resistance_in_impacts),
               .applies_when = {of_rigid_rocks(Otherwise::kept)},
               .title = "Rolling resistance in impacts",
               .group = "Restitution",
               .meaning = "rolling friction also acts on the impulse of an impact, so that a rock that bounces along "
                          "the ground loses as much as one that rolls there.",
               .source = "Talus; false in RocFall2 and RocFall3"},
          },
      .groups = {{"Motion"}, {"Restitution", true}, {"When a rock stops", true}},
      .topic = topics::equations,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
