#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> plan_line_slot() {
  return [](Row row) -> Slot { return PlanLineSlot{std::get<Barrier*>(row)}; };
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

/// What barriers and collectors have in common.
std::vector<Setting> line_settings(std::string_view unnamed) {
  return {
      {.key = "name",
       .slot = member(&Barrier::name),
       .without_it = unnamed,
       .meaning = "What results call it; no other barrier or collector has it.",
       .source = "Talus"},
      {.key = "line",
       .slot = plan_line_slot(),
       .unit = "m",
       .required = true,
       .meaning = "Where it stands: x in 2D; two or more points [x, y] on plan in 3D.",
       .source = "Talus"},
      {.key = "height_m",
       .slot = member(&Barrier::height_m),
       .unit = "m",
       .range = above_0_up_to(most_height_m, "it could not be hit", "nothing is built so high"),
       .required = true,
       .meaning = "Height along it, from the ground at its foot.",
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
       .meaning = "Lean from the vertical, positive towards the right of the line's direction (2D: towards +x).",
       .source = "Talus"},
  };
}

}  // namespace

Table barrier_table() {
  Table table{
      .key = "barrier",
      .repeated = true,
      .meaning = "Something that stops rocks; any number of entries.",
      .settings = line_settings("`barrier N`, N counted from 1"),
      .topic = topics::points,
      .add = [](Project& project) { return added_barrier(project, false); },
      .rows = [](Project& project) { return all_barriers(project, false); },
  };
  // Nets are up to 10 m high, embankments up to some 25 m. (A collector may be as high as it takes.)
  const auto height =
      std::ranges::find_if(table.settings, [](const Setting& setting) { return setting.key == "height_m"; });
  height->doubt = beyond(30, "no barrier was built so high", "A line that only records is a [[collector]]");
  table.settings.push_back({.key = "capacity_kJ",
                            .slot = member(&Barrier::capacity_kJ),
                            .unit = "kJ",
                            .range = {.least = 0,
                                      .most = most_energy_kJ,
                                      .least_excluded = true,
                                      .infinite_allowed = true,
                                      .too_low = "it could stop nothing, and a [[collector]] is what only counts",
                                      .too_high = "what stops every rock has the capacity inf"},
                            .meaning = "Kinetic energy that it takes; a rock with more breaks through with the excess.",
                            .source = "the manual, section 4, has barriers of infinite capacity"});
  table.settings.push_back({.key = "normal_restitution",
                            .slot = member(&Barrier::normal_restitution),
                            .range = restitution,
                            .without_it = "it holds what it stops",
                            .meaning = "Rn of a rock that bounces off it; given with `tangential_restitution`.",
                            .source = "Talus",
                            .slip = restitution_slip});
  table.settings.push_back({.key = "tangential_restitution",
                            .slot = member(&Barrier::tangential_restitution),
                            .range = restitution,
                            .without_it = "it holds what it stops",
                            .meaning = "Rt of a rock that bounces off it; given with `normal_restitution`.",
                            .source = "Talus",
                            .slip = restitution_slip});
  return table;
}

Table collector_table() {
  return {
      .key = "collector",
      .repeated = true,
      .meaning = "Something that records the rocks that pass it and does not touch them; any number of entries.",
      .settings = line_settings("`collector N`, N counted from 1"),
      .topic = topics::points,
      .add = [](Project& project) { return added_barrier(project, true); },
      .rows = [](Project& project) { return all_barriers(project, true); },
  };
}

}  // namespace talus::project::declared
