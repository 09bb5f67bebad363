#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numbers>

#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "talus/archive/result_tables.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/rocks/energy.hpp"
#include "talus/rocks/heights.hpp"

namespace talus::cli {

namespace {

struct ReplayOptions {
  ProjectOptions project;
  std::uint64_t rock = 0;
  bool csv = false;
};

void print_row(const TableContext& context, const RockRecord& record, const char* state, const Motion& motion) {
  const Vec3 p = context.frame.global_from_local(motion.position);
  const Vec3 &v = motion.velocity, &w = motion.spin;
  const double kinetic = kinetic_energy(record.body, motion);
  const double potential = record.body.mass * context.gravity * (p.z() - context.energy_datum);
  fmt::print(
      "{:<11}{:>10.5f}{:>14.5f}{:>14.5f}{:>14.5f}{:>11.5f}{:>11.5f}{:>11.5f}{:>11.5f}{:>11.5f}{:>11.5f}{:>12.3f}{:>12."
      "3f}{:>12.3f}\n",
      state, motion.time, p.x(), p.y(), p.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z(), kinetic / 1000,
      potential / 1000, (kinetic + potential) / 1000);
}

int replay(const ReplayOptions& options) {
  take_available_threads();
  const Loaded loaded = load(options.project);
  if (options.rock >= loaded.model.rocks()) {
    throw BadInput(Problem{.file = options.project.file.string(),
                           .where = "--rock",
                           .what = fmt::format("there is no rock {}", options.rock),
                           .why = fmt::format("the project has rocks 0 to {}", loaded.model.rocks() - 1)});
  }
  Simulator simulator(loaded.model);
  const RockRecord record = simulator.simulate(options.rock, true);
  const RockLog& log = simulator.log();
  const TableContext context = TableContext::of(loaded.model);
  if (options.csv) {
    const std::size_t columns = columns_in_run<PathEventRow>(context.has_blocks);
    std::string text = header_of<PathEventRow>({}, columns);
    PathEventRow row;
    for (std::size_t k = 0; k < log.rows.size(); ++k) {
      fill(row, context, record, k, log.rows[k]);
      append_row(text, row, nullptr, columns);
    }
    fmt::print("{}", text);
    return done;
  }

  print_warnings(loaded.warnings);
  fmt::print("rock {} of seeder \"{}\": {:.6g} kg, radius {:.6g} m\n", record.rock,
             context.seeders[record.seeder.index], record.body.mass, record.body.radius);
  fmt::print("{:<11}{:>10}{:>14}{:>14}{:>14}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>12}{:>12}{:>12}\n", "state", "t [s]",
             "x [m]", "y [m]", "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]", "wx [rad/s]", "wy [rad/s]", "wz [rad/s]",
             "KE [kJ]", "PE [kJ]", "total [kJ]");
  auto turn = log.turns.begin();
  for (const PathRow& row : log.rows) {
    for (; turn != log.turns.end() && turn->time < row.motion.time; ++turn)
      print_row(context, record, "turns back", *turn);
    print_row(context, record, name(row.state), row.motion);
  }
  for (const Passage& hit : log.hits) {
    fmt::print(
        "{}: {} at t = {:.5f} s, contact {:.3f} m and top {:.3f} m above its foot, {:.1f} degrees to its "
        "normal\n",
        context.barriers[hit.barrier.index], name(hit.outcome), hit.motion.time, hit.height,
        top_over(hit.lowest, hit.half_height_of(record.body.radius)), hit.angle() * 180 / std::numbers::pi);
  }
  for (const Passage& passed : log.passed_above) {
    fmt::print("{}: passed above with {:.3f} m to spare\n", context.barriers[passed.barrier.index], passed.clearance);
  }
  const RockOutcome& outcome = record.outcome;
  fmt::print(
      "ended: {}; maximum total kinetic energy {:.3f} kJ, maximum bounce height {:.3f} m (of its lowest point)\n",
      name(outcome.reason), outcome.max_kinetic_energy / 1000, outcome.max_bounce);
  return done;
}

}  // namespace

Command add_replay(CLI::App& app) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "Simulate one rock of a project again and print every event");
  add_project(*command, options->project);
  command->add_option("--rock", options->rock, "Number of the rock, as in endpoints.csv (zero-based)")
      ->transform(natural_number())
      ->required()
      ->type_name("N");
  command->add_flag("--csv", options->csv, "Print the rows of paths.csv instead of a table");
  return {command, [options] { return replay(*options); }};
}

}  // namespace talus::cli
