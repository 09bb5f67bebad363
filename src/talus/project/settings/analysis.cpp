#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {

Table analysis_table() {
  auto [add, rows] = one_row(&Project::analysis);
  return {
      .key = "analysis",
      .meaning = "How rocks move.",
      .settings =
          {
              {.key = "model",
               .slot = member(&Analysis::model),
               .meaning = "A rock is a point with mass and spin (`lumped_mass`, the law of CRSP) or a sphere with a "
                          "radius (`rigid_sphere`).",
               .source = "the manual, sections 2 and 7"},
              {.key = "rotation",
               .slot = member(&Analysis::rotation),
               .only_for = RockModel::lumped_mass,
               .meaning = "impacts couple spin and velocity; without it they are plain restitution.",
               .source = "RocFall: \"consider rotational velocity\""},
              {.key = "gravity_m_s2",
               .slot = member(&Analysis::gravity_m_s2),
               .unit = "m/s2",
               .range = {.least = least_gravity_m_s2,
                         .most = most_gravity_m_s2,
                         .too_low = "gravity is given as a magnitude, it points down by itself"},
               .meaning = "Acceleration of gravity.",
               .source = "standard gravity, as in the tables of RocFall2 and RocFall3; the manual's hand calculations "
                         "use 9.81",
               .slip = sign_slip},
              {.key = "sliding",
               .slot = member(&Analysis::sliding),
               .only_for = RockModel::lumped_mass,
               .meaning = "sliding is integrated in time steps as RocFall3 does (`stepped`) or solved exactly facet by "
                          "facet as RocFall2 does (`closed_form`).",
               .source = "the manual, section 3"},
              {.key = "max_timestep_s",
               .slot = member(&Analysis::max_timestep_s),
               .unit = "s",
               .range = {.least = 1e-4,
                         .most = most_time_s,
                         .too_low = "one slide would take billions of shorter steps"},
               .meaning = "Time step of stepped sliding and of rolling.",
               .source = "RocFall3"},
              {.key = "normal_velocity_cutoff_m_s",
               .slot = member(&Analysis::normal_velocity_cutoff_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s),
               .meaning = "A rock that leaves an impact with a smaller normal velocity stays on the ground and slides "
                          "or rolls.",
               .source = "RocFall2 and RocFall3"},
              {.key = "grazing_angle_deg",
               .slot = member(&Analysis::grazing_angle_deg),
               .unit = "deg",
               .range = up_to(45),
               .only_for = RockModel::lumped_mass,
               .meaning =
                   "a rock that slides is not struck by ground that it meets at a smaller angle: it slides "
                   "on, with the friction of what it presses with. The default is for rounded heights; take 1 to "
                   "5 for fine grids of smooth ground, 0 for an impact at every bend, as in RocFall.",
               .source = "Talus"},
              {.key = "stopped_velocity_m_s",
               .slot = member(&Analysis::stopped_velocity_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s),
               .meaning = "A slower rock is at rest where friction can hold it.",
               .source = "RocFall2 and RocFall3"},
              {.key = "max_steps",
               .slot = member(&Analysis::max_steps),
               .range = between(1, 1e9),
               .meaning =
                   "A rock with more flights, impacts and stretches along the ground than this, counted together, is "
                   "ended and counted as such.",
               .source = "Talus"},
              {.key = "max_time_s",
               .slot = member(&Analysis::max_time_s),
               .unit = "s",
               .range = above_0_up_to(most_time_s),
               .meaning = "A rock that moves longer than this is ended and counted as such.",
               .source = "Talus"},
              {.key = "energy_datum_m",
               .slot = member(&Analysis::energy_datum_m),
               .unit = "m",
               .range = place,
               .without_it = "the lowest point of the terrain",
               .meaning = "Height at which potential energy is zero.",
               .source = "the manual: 0 in sections 2, 3 and 7, the lowest vertex in sections 1 and 6"},
              {.key = "friction_angle",
               .slot = member(&Analysis::friction_angle),
               .only_for = RockModel::lumped_mass,
               .meaning = "the friction angle of sliding is the material's, follows from its tangential restitution, "
                          "phi = arctan((1 - Rt) / Rt), or is zero.",
               .source = "RocFall"},
              {.key = "scale_rn_by_velocity",
               .slot = member(&Analysis::scale_rn_by_velocity),
               .meaning = "Faster impacts rebound less: Rn / (1 + (vn / K)^2), K being `rn_velocity_scale_m_s`.",
               .source = "Pfeiffer and Bowen 1989 (CRSP)"},
              {.key = "rn_velocity_scale_m_s",
               .slot = member(&Analysis::rn_velocity_scale_m_s),
               .unit = "m/s",
               .range = above_0_up_to(most_speed_m_s),
               .meaning = "Normal velocity at which scaling by velocity halves the normal restitution.",
               .source = "30 ft/s, Pfeiffer and Bowen 1989 (CRSP)"},
              {.key = "scale_rn_by_mass",
               .slot = member(&Analysis::scale_rn_by_mass),
               .meaning = "Heavier rocks rebound less: Rn / (1 + (m / K)^2), K being `rn_mass_scale_kg`.",
               .source = "RocFall"},
              {.key = "rn_mass_scale_kg",
               .slot = member(&Analysis::rn_mass_scale_kg),
               .unit = "kg",
               .range = above_0_up_to(most_mass_kg),
               .meaning = "Mass at which scaling by mass halves the normal restitution.",
               .source = "RocFall"},
              {.key = "tangential_crsp_damping",
               .slot = member(&Analysis::tangential_crsp_damping),
               .only_for = RockModel::rigid_sphere,
               .meaning = "the tangential velocity after an impact is damped as by CRSP.",
               .source = "RocFall3"},
          },
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
