#include "talus/archive/result_tables.hpp"

#include <array>
#include <numbers>

#include "talus/results/summary.hpp"

namespace talus {

TableContext TableContext::of(const Model& model) {
  TableContext context{model.frame, model.laws.gravity.norm(), model.energy_datum, {}, {}};
  for (const Seeder& seeder : model.seeders) context.seeders.push_back(seeder.name);
  for (const Barrier& barrier : model.barriers) context.barriers.push_back(barrier.name);
  return context;
}

namespace {

double translational_energy(const Rock& rock, const Motion& motion) {
  return 0.5 * rock.mass * motion.velocity.squaredNorm();
}
double rotational_energy(const Rock& rock, const Motion& motion) {
  return 0.5 * rock.inertia * motion.spin.squaredNorm();
}

/// The text of the rows of a block.
struct TextPart : ObserverPart {
  explicit TextPart(const TableContext& c) : context(c) {}
  const TableContext& context;
  std::string text;
};
template <class Row>
struct RowsPart : TextPart {
  using TextPart::TextPart;
  template <class... Seen>
  void add(const Seen&... seen) {
    fill(row, context, seen...);
    append_row(text, row, &memory);
  }
  Row row;
  CsvMemory memory;
};

struct EndpointsPart : RowsPart<EndpointRow> {
  EndpointsPart(const TableContext& c, const TableRocks& r) : RowsPart(c), rocks(r) {}
  void see(const RockRecord& record, const RockLog&) override {
    if (rocks.has_endpoint(record.rock)) add(record);
  }
  const TableRocks& rocks;
};

struct PathsPart : RowsPart<PathEventRow> {
  PathsPart(const TableContext& c, const PathsTable& t) : RowsPart(c), table(t) {}
  void see(const RockRecord& record, const RockLog& log) override {
    if (!table.wants_rows(record.rock)) return;
    for (std::size_t k = 0; k < log.rows.size(); ++k) add(record, k, log.rows[k]);
  }
  const PathsTable& table;
};

struct BarriersPart : RowsPart<HitRow> {
  using RowsPart::RowsPart;
  void see(const RockRecord& record, const RockLog& log) override {
    for (const BarrierHit& hit : log.hits) add(record, hit);
  }
};

}  // namespace

void fill(EndpointRow& row, const TableContext& context, const RockRecord& record) {
  const RockOutcome& outcome = record.outcome;
  const Runout way = runout(outcome);
  row.rock = record.rock;
  row.seeder = context.seeders[record.seeder.index];
  row.position_m = coordinates(context.frame.global_from_local(outcome.end.position));
  row.runout_xy_m = way.plan;
  row.runout_z_m = way.drop;
  row.runout_total_m = way.total;
  row.time_s = outcome.end.time;
  row.events = static_cast<std::uint64_t>(outcome.events);
  row.end_reason = outcome.reason;
  row.mass_kg = record.body.mass;
  row.radius_m = record.body.radius;
  row.max_ke_J = outcome.max_kinetic_energy;
  row.max_bounce_m = outcome.max_bounce;
}

void fill(PathEventRow& row, const TableContext& context, const RockRecord& record, std::size_t event,
          const PathRow& seen) {
  const Vec3 position = context.frame.global_from_local(seen.motion.position);
  row.rock = record.rock;
  row.event = event;
  row.state = seen.state;
  row.time_s = seen.motion.time;
  row.position_m = coordinates(position);
  row.velocity_m_s = coordinates(seen.motion.velocity);
  row.spin_rad_s = coordinates(seen.motion.spin);
  row.ke_translational_J = translational_energy(record.body, seen.motion);
  row.ke_rotational_J = rotational_energy(record.body, seen.motion);
  row.pe_J = record.body.mass * context.gravity * (position.z() - context.energy_datum);
}

void fill(HitRow& row, const TableContext& context, const RockRecord& record, const BarrierHit& hit) {
  row.barrier = context.barriers[hit.barrier.index];
  row.rock = record.rock;
  row.time_s = hit.motion.time;
  row.position_m = coordinates(context.frame.global_from_local(hit.motion.position));
  row.impact_height_m = hit.height;
  row.velocity_m_s = coordinates(hit.motion.velocity);
  row.angle_deg = hit.angle * 180 / std::numbers::pi;
  row.ke_translational_J = translational_energy(record.body, hit.motion);
  row.ke_rotational_J = rotational_energy(record.body, hit.motion);
  row.ke_total_J = row.ke_translational_J + row.ke_rotational_J;
  row.outcome = hit.outcome;
}

void TableObserver::commit(ObserverPart& part) { sink_.write(static_cast<TextPart&>(part).text); }

EndpointsTable::EndpointsTable(TableContext context, TextSink& sink, const TableRocks& rocks)
    : TableObserver(std::move(context), sink), rocks_(rocks) {}
std::unique_ptr<ObserverPart> EndpointsTable::new_part() const {
  return std::make_unique<EndpointsPart>(context(), rocks_);
}

PathsTable::PathsTable(TableContext context, TextSink& sink, const TableRocks& rocks)
    : TableObserver(std::move(context), sink), rocks_(rocks) {}
std::unique_ptr<ObserverPart> PathsTable::new_part() const { return std::make_unique<PathsPart>(context(), *this); }

std::unique_ptr<ObserverPart> BarriersTable::new_part() const { return std::make_unique<BarriersPart>(context()); }

}  // namespace talus
