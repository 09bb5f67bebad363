#include "talus/archive/result_tables.hpp"

#include <numbers>

#include "talus/files/csv_text.hpp"
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
CsvRow& operator<<(CsvRow& row, const Vec3& v) { return row << v.x() << v.y() << v.z(); }

struct TextPart : ObserverPart {
  explicit TextPart(const TableContext& c) : context(c) {}
  const TableContext& context;
  std::string text;
};

struct EndpointsPart : TextPart {
  EndpointsPart(const TableContext& c, const io::TableRocks& r) : TextPart(c), rocks(r) {}
  void see(const RockRecord& record, const RockLog&) override {
    if (rocks.has_endpoint(record.rock)) append_endpoint_row(text, context, record, &memory);
  }
  const io::TableRocks& rocks;
  CsvMemory memory;
};

struct PathsPart : TextPart {
  PathsPart(const TableContext& c, const PathsTable& t) : TextPart(c), table(t) {}
  void see(const RockRecord& record, const RockLog& log) override {
    if (!table.wants_rows(record.rock)) return;
    for (std::size_t k = 0; k < log.rows.size(); ++k) append_path_row(text, context, record, k, log.rows[k], &memory);
  }
  const PathsTable& table;
  CsvMemory memory;
};

struct BarriersPart : TextPart {
  using TextPart::TextPart;
  void see(const RockRecord& record, const RockLog& log) override {
    for (const BarrierHit& hit : log.hits) {
      const double translational = translational_energy(record.body, hit.motion);
      const double rotational = rotational_energy(record.body, hit.motion);
      CsvRow row(text, &memory);
      row << context.barriers[hit.barrier.index] << record.rock << hit.motion.time
          << context.frame.global_from_local(hit.motion.position) << hit.height << hit.motion.velocity
          << hit.angle * 180 / std::numbers::pi << translational << rotational << translational + rotational
          << name(hit.outcome);
      row.end();
    }
  }
  CsvMemory memory;
};

}  // namespace

void append_endpoint_row(std::string& text, const TableContext& context, const RockRecord& record, CsvMemory* memory) {
  const RockOutcome& outcome = record.outcome;
  const Runout way = runout(outcome);
  CsvRow row(text, memory);
  row << record.rock << context.seeders[record.seeder.index] << context.frame.global_from_local(outcome.end.position)
      << way.plan << way.drop << way.total << outcome.end.time << outcome.events << name(outcome.reason)
      << record.body.mass << record.body.radius << outcome.max_kinetic_energy << outcome.max_bounce;
  row.end();
}

void append_path_row(std::string& text, const TableContext& context, const RockRecord& record, std::size_t event,
                     const PathRow& row, CsvMemory* memory) {
  const Vec3 position = context.frame.global_from_local(row.motion.position);
  CsvRow out(text, memory);
  out << record.rock << event << name(row.state) << row.motion.time << position << row.motion.velocity
      << row.motion.spin << translational_energy(record.body, row.motion) << rotational_energy(record.body, row.motion)
      << record.body.mass * context.gravity * (position.z() - context.energy_datum);
  out.end();
}

std::string_view path_header() {
  return "rock,event,state,time_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,ke_translational_J,"
         "ke_rotational_J,pe_J\n";
}

void TableObserver::commit(ObserverPart& part) { sink_.write(static_cast<TextPart&>(part).text); }

EndpointsTable::EndpointsTable(TableContext context, TextSink& sink, const io::TableRocks& rocks)
    : TableObserver(std::move(context), sink), rocks_(rocks) {}
std::unique_ptr<ObserverPart> EndpointsTable::new_part() const {
  return std::make_unique<EndpointsPart>(context(), rocks_);
}
std::string_view EndpointsTable::header() const {
  return "rock,seeder,x_m,y_m,z_m,runout_xy_m,runout_z_m,runout_total_m,time_s,events,end_reason,mass_kg,radius_m,"
         "max_ke_J,max_bounce_m\n";
}

PathsTable::PathsTable(TableContext context, TextSink& sink, const io::TableRocks& rocks)
    : TableObserver(std::move(context), sink), rocks_(rocks) {}
std::unique_ptr<ObserverPart> PathsTable::new_part() const { return std::make_unique<PathsPart>(context(), *this); }
std::string_view PathsTable::header() const { return path_header(); }

std::unique_ptr<ObserverPart> BarriersTable::new_part() const { return std::make_unique<BarriersPart>(context()); }
std::string_view BarriersTable::header() const {
  return "barrier,rock,time_s,x_m,y_m,z_m,impact_height_m,vx_m_s,vy_m_s,vz_m_s,angle_deg,ke_translational_J,"
         "ke_rotational_J,ke_total_J,outcome\n";
}

}  // namespace talus
