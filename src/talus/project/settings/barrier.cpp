#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> barrier_line_slot() {
  return [](const Row& row) -> Slot { return PlanLineSlot{&row.as<Barrier>().line}; };
}

Row added_barrier(Project& project, bool is_collector) {
  Barrier& barrier = project.barriers.emplace_back();
  barrier.is_collector = is_collector;
  return &barrier;
}

std::vector<Row> all_barriers(Project& project, bool are_collectors) {
  std::vector<Row> rows;
  for (Barrier& barrier : project.barriers) {
    if (barrier.is_collector == are_collectors) rows.push_back(&barrier);
  }
  return rows;
}

/// The settings that barriers and collectors share.
std::vector<Setting> line_settings(std::string_view default_name) {
  return {
      {.key = "name",
       .slot = member(&Barrier::name),
       .without_it = default_name,
       .meaning = "Name in the results; must be unique among barriers and collectors.",
       .source = "Talus"},
      {.key = "line",
       .slot = barrier_line_slot(),
       .unit = "m",
       .required = true,
       .meaning = "Position: x in 2D; two or more points [x, y] on plan in 3D.",
       .source = "Talus"},
      {.key = "height_m",
       .slot = member(&Barrier::height_m),
       .unit = "m",
       .range = above_0_up_to(most_height_m, "nothing could hit it", "nothing is built that high"),
       .required = true,
       .meaning = "Height along its face, from the ground at its foot.",
       .source = "the manual, section 4"},
      {.key = "inclination_deg",
       .slot = member(&Barrier::inclination_deg),
       .unit = "deg",
       .range = {.least = -90,
                 .most = 90,
                 .least_excluded = true,
                 .most_excluded = true,
                 .too_low = "it would lie on the ground",
                 .too_high = "it would lie on the ground"},
       .meaning = "Lean from the vertical, positive to the right of the line's direction (2D: towards +x).",
       .source = "Talus"},
  };
}

}  // namespace

Table barrier_table() {
  Table table{
      .key = "barrier",
      .repeated = true,
      .meaning = "A fence, net, wall or dam that stops rocks; any number of entries.",
      .settings = line_settings("`barrier N`, numbered from 1"),
      .topic = topics::points,
      .add = [](Project& project) { return added_barrier(project, false); },
      .rows = [](Project& project) { return all_barriers(project, false); },
  };
  // Nets are up to 10 m high, embankments up to about 25 m. (A collector may have any height.)
  const auto height =
      std::ranges::find_if(table.settings, [](const Setting& setting) { return setting.key == "height_m"; });
  height->doubt = beyond(30, "no barrier of this height has been built",
                         "To record rocks without stopping them, use a [[collector]]");
  table.settings.push_back(
      {.key = "capacity_kJ",
       .slot = member(&Barrier::capacity_kJ),
       .unit = "kJ",
       .range = {.least = 0,
                 .most = most_energy_kJ,
                 .least_excluded = true,
                 .infinite_allowed = true,
                 .too_low = "it would stop nothing; a [[collector]] records rocks without stopping them",
                 .too_high = "use inf for a barrier that stops every rock"},
       .meaning = "Kinetic energy that it absorbs; a rock with more breaks through and keeps the excess.",
       .source = "the manual, section 4, has barriers of infinite capacity"});
  table.settings.push_back({.key = "normal_restitution",
                            .slot = member(&Barrier::normal_restitution),
                            .range = restitution,
                            .without_it = "it holds the rocks it stops",
                            .meaning = "Rn of rocks that bounce off it; needs `tangential_restitution`.",
                            .source = "Talus",
                            .slip = restitution_slip});
  table.settings.push_back({.key = "tangential_restitution",
                            .slot = member(&Barrier::tangential_restitution),
                            .range = restitution,
                            .without_it = "it holds the rocks it stops",
                            .meaning = "Rt of rocks that bounce off it; needs `normal_restitution`.",
                            .source = "Talus",
                            .slip = restitution_slip});
  return table;
}

Table collector_table() {
  return {
      .key = "collector",
      .repeated = true,
      .meaning = "A line that records passing rocks without touching them; any number of entries.",
      .settings = line_settings("`collector N`, numbered from 1"),
      .topic = topics::points,
      .add = [](Project& project) { return added_barrier(project, true); },
      .rows = [](Project& project) { return all_barriers(project, true); },
  };
}

}  // namespace talus::project::declared
