#include "talus/verification/observed.hpp"

#include <algorithm>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/core/degrees.hpp"
#include "talus/results/summary.hpp"
#include "talus/rocks/energy.hpp"
#include "talus/trajectory/motion_at.hpp"

namespace talus::verification {
namespace {

struct PathQuantityName {
  PathQuantity quantity;
  std::string_view name;
  Kind kind;
};
using enum PathQuantity;
constexpr std::array path_quantities{
    PathQuantityName{time, "time", Kind::time},
    PathQuantityName{time_to_next, "time_to_next", Kind::time},
    PathQuantityName{x, "x", Kind::position},
    PathQuantityName{y, "y", Kind::position},
    PathQuantityName{z, "z", Kind::position},
    PathQuantityName{vx, "vx", Kind::velocity},
    PathQuantityName{vy, "vy", Kind::velocity},
    PathQuantityName{vz, "vz", Kind::velocity},
    PathQuantityName{wx, "wx", Kind::spin},
    PathQuantityName{wy, "wy", Kind::spin},
    PathQuantityName{wz, "wz", Kind::spin},
    PathQuantityName{spin, "spin", Kind::spin},
    PathQuantityName{kinetic_J, "kinetic_J", Kind::energy},
    PathQuantityName{potential_J, "potential_J", Kind::energy},
    PathQuantityName{total_J, "total_J", Kind::energy},
    PathQuantityName{kinetic_kJ, "kinetic_kJ", Kind::energy},
    PathQuantityName{potential_kJ, "potential_kJ", Kind::energy},
    PathQuantityName{total_kJ, "total_kJ", Kind::energy},
    PathQuantityName{spin_a, "spin_a", Kind::spin},
    PathQuantityName{spin_b, "spin_b", Kind::spin},
    PathQuantityName{spin_c, "spin_c", Kind::spin},
    PathQuantityName{turned_deg, "turned_deg", Kind::angle},
};

constexpr std::array<std::string_view, sample_quantity_count> sample_names{
    "runout_xy_m", "end_x_m", "barrier_ke_translational_kJ", "barrier_height_m"};

Event event_of(const Model& model, const Rock& rock, const Motion& motion) {
  Event event{motion, 0, 0, {}};
  event.motion.position = model.frame.global_from_local(motion.position);
  event.kinetic = kinetic_energy(rock, motion);
  event.potential = rock.mass * model.laws.gravity.norm() * (event.motion.position.z() - model.energy_datum);
  return event;
}

double energy_rise(const Model& model, const Rock& rock, const RockLog& log) {
  double rise = 0, lowest = 1e300, greatest = 0, before = 1e300;
  for (const PathRow& row : log.rows) {
    const Event event = event_of(model, rock, row.motion);
    const double total = event.kinetic + event.potential;
    rise = std::max(rise, total - before);
    before = total;
    lowest = std::min(lowest, event.potential);
    greatest = std::max(greatest, total);
  }
  return greatest > lowest ? rise / (greatest - lowest) : rise;
}

struct ObservedPart : ObserverPart {
  ObservedPart(const Model& m, Energies e) : model(m), energies(e) {}
  void see(const RockRecord& record, const RockLog& log) override {
    const auto add = [&](SampleQuantity quantity, double value) {
      observed.samples[static_cast<std::size_t>(quantity)].push_back(value);
    };
    ++observed.rocks;
    ++observed.ends[static_cast<std::size_t>(record.outcome.reason)];
    add(SampleQuantity::runout_xy_m, runout(record.outcome, model.runout_frame).plan);
    add(SampleQuantity::end_x_m, model.frame.global_from_local(record.outcome.end.position).x());
    for (const Passage& hit : log.hits) {
      add(SampleQuantity::barrier_ke_translational_kJ, translational_energy(record.body, hit.motion) / 1000);
      add(SampleQuantity::barrier_height_m, hit.height);
    }
    if (energies == Energies::watch) {
      observed.max_energy_rise = std::max(observed.max_energy_rise, energy_rise(model, record.body, log));
    }
  }
  const Model& model;
  Energies energies;
  Observed observed;
};

class Collector : public Observer {
 public:
  Collector(const Model& model, Energies energies) : model_(model), energies_(energies) {}
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return energies_ == Energies::watch; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override {
    return std::make_unique<ObservedPart>(model_, energies_);
  }
  void commit(ObserverPart& part) override {
    const Observed& more = static_cast<ObservedPart&>(part).observed;
    all.rocks += more.rocks;
    for (std::size_t k = 0; k < all.samples.size(); ++k) {
      all.samples[k].insert(all.samples[k].end(), more.samples[k].begin(), more.samples[k].end());
    }
    for (std::size_t k = 0; k < all.ends.size(); ++k) all.ends[k] += more.ends[k];
    all.max_energy_rise = std::max(all.max_energy_rise, more.max_energy_rise);
  }
  Observed all;

 private:
  const Model& model_;
  Energies energies_;
};

}  // namespace

std::string_view name(PathQuantity quantity) {
  return std::ranges::find(path_quantities, quantity, &PathQuantityName::quantity)->name;
}
std::optional<PathQuantity> path_quantity_of(std::string_view text) {
  const auto found = std::ranges::find(path_quantities, text, &PathQuantityName::name);
  return found == path_quantities.end() ? std::nullopt : std::optional(found->quantity);
}
std::vector<std::string_view> path_quantity_names() {
  std::vector<std::string_view> names;
  for (const auto& known : path_quantities) names.push_back(known.name);
  return names;
}
Kind kind_of(PathQuantity quantity) {
  return std::ranges::find(path_quantities, quantity, &PathQuantityName::quantity)->kind;
}

std::string_view name(SampleQuantity quantity) { return sample_names[static_cast<std::size_t>(quantity)]; }
std::optional<SampleQuantity> sample_quantity_of(std::string_view text) {
  const auto found = std::ranges::find(sample_names, text);
  if (found == sample_names.end()) return std::nullopt;
  return static_cast<SampleQuantity>(found - sample_names.begin());
}
std::vector<std::string_view> sample_quantity_names() { return {sample_names.begin(), sample_names.end()}; }

std::optional<double> value(PathQuantity quantity, const Event& event, const Event* next) {
  const Motion& motion = event.motion;
  const auto& turning = event.turning;
  switch (quantity) {
    case time:
      return motion.time;
    case time_to_next:
      return next == nullptr ? std::nullopt : std::optional(next->motion.time - motion.time);
    case x:
      return motion.position.x();
    case y:
      return motion.position.y();
    case z:
      return motion.position.z();
    case vx:
      return motion.velocity.x();
    case vy:
      return motion.velocity.y();
    case vz:
      return motion.velocity.z();
    case wx:
      return motion.spin.x();
    case wy:
      return motion.spin.y();
    case wz:
      return motion.spin.z();
    case spin:
      return motion.spin.norm();
    case kinetic_J:
      return event.kinetic;
    case potential_J:
      return event.potential;
    case total_J:
      return event.kinetic + event.potential;
    case kinetic_kJ:
      return event.kinetic / 1000;
    case potential_kJ:
      return event.potential / 1000;
    case total_kJ:
      return (event.kinetic + event.potential) / 1000;
    case spin_a:
      return turning ? std::optional(turning->spin.x()) : std::nullopt;
    case spin_b:
      return turning ? std::optional(turning->spin.y()) : std::nullopt;
    case spin_c:
      return turning ? std::optional(turning->spin.z()) : std::nullopt;
    case turned_deg:
      return turning ? std::optional(turning->angle / radians) : std::nullopt;
  }
  return std::nullopt;
}

std::vector<Event> path_of(const Model& model, std::uint64_t rock) {
  Simulator simulator(model);
  const RockRecord record = simulator.simulate(rock, true);
  const RockLog& log = simulator.log();
  std::vector<Event> events;
  auto turn = log.turns.begin();
  for (const PathRow& row : log.rows) {
    for (; turn != log.turns.end() && turn->time < row.motion.time; ++turn) {
      events.push_back(event_of(model, record.body, *turn));
    }
    events.push_back(event_of(model, record.body, row.motion));
  }
  return events;
}

std::vector<Event> path_at(const Model& model, std::uint64_t rock, std::span<const double> times) {
  Simulator simulator(model);
  const RockRecord record = simulator.simulate(rock, true, true);
  const std::optional<RockBlock> block = block_of(model, rock);
  const std::vector<Attitude>& attitudes = simulator.log().attitudes;
  std::vector<PathPiece> pieces;
  simulator.log().for_each_piece([&](const PathPiece& piece) { pieces.push_back(piece); });
  std::vector<Event> events;
  for (const double time : times) {
    Event& event = events.emplace_back(event_of(model, record.body, motion_at(pieces, time)));
    if (!block) continue;
    const auto [orientation, spin] = turned_at(attitudes, block->inertia, time);
    event.motion.spin = spin;  // the energy is the same as with that of its sphere
    event.turning = {orientation.to_body(spin), angle_between(attitudes.front().orientation, orientation)};
  }
  return events;
}

Observed observe(const Model& model, Energies energies) {
  Collector collector(model, energies);
  Observer* const observers[] = {&collector};
  run_campaign(model, observers, {});
  return std::move(collector.all);
}

}  // namespace talus::verification
