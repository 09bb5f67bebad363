#include "talus/archive/result_tables.hpp"

#include <array>
#include <numbers>

#include "talus/archive/rows_of_rock.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/results/summary.hpp"
#include "talus/rocks/energy.hpp"
#include "talus/rocks/heights.hpp"

namespace talus {

TableContext TableContext::of(const Model& model) {
  TableContext context{.frame = model.frame,
                       .gravity = model.laws.gravity.norm(),
                       .energy_datum = model.energy_datum,
                       .runout_frame = model.runout_frame,
                       .ensembles = model.ensembles.size(),
                       .has_blocks = talus::has_blocks(model),
                       .parts = &model.parts};
  for (const Seeder& seeder : model.seeders) context.seeders.push_back(seeder.name);
  for (const Barrier& barrier : model.barriers) context.barriers.push_back(barrier.name);
  for (const Material& material : model.ground.materials()) context.materials.push_back(material.name);
  return context;
}

namespace {

std::optional<std::uint64_t> ensemble_in(const TableContext& context, const RockRecord& record) {
  return context.ensembles > 0 ? std::optional(ensemble_of(record.rock, context.ensembles)) : std::nullopt;
}

/// The text of the rows of a block.
template <class Row>
class RowsText {
 public:
  explicit RowsText(const TableContext& context)
      : context_(context), columns_(columns_in_run<Row>(context.has_blocks)) {}
  template <class... Seen>
  void add(const Seen&... seen) {
    fill(row_, context_, seen...);
    append_row(text_, row_, &memory_, columns_);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  const TableContext& context_;
  std::size_t columns_;
  std::string text_;
  Row row_;
  CsvMemory memory_;
};

template <class Row>
class TableObserver : public Observer {
 public:
  TableObserver(const TableContext& context, const TableRocks& rocks, TextSink& sink)
      : context_(context), rocks_(rocks), sink_(sink) {}
  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override { return RowsOfRock<Row>::need_path(rocks_, rock); }
  [[nodiscard]] bool wants_impacts(std::uint64_t rock) const override {
    return RowsOfRock<Row>::need_impacts(rocks_, rock);
  }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override {
    return std::make_unique<Part>(context_, rocks_);
  }
  void commit(ObserverPart& part) override { sink_.write(static_cast<Part&>(part).text.text()); }

 private:
  struct Part : ObserverPart {
    Part(const TableContext& context, const TableRocks& r) : rocks(r), text(context) {}
    void see(const RockRecord& record, const RockLog& log) override {
      RowsOfRock<Row>::visit(rocks, record, log, [&](const auto&... seen) { text.add(seen...); });
    }
    const TableRocks& rocks;
    RowsText<Row> text;
  };

  TableContext context_;
  TableRocks rocks_;
  TextSink& sink_;
};

template <class Row>
ResultTable table_of() {
  return {Row::file_name,
          [](const TableContext& context) { return header_of<Row>({}, columns_in_run<Row>(context.has_blocks)); },
          [](const TableRocks& rocks) { return RowsOfRock<Row>::are_wanted(rocks); },
          [](const TableContext& context, const TableRocks& rocks, TextSink& sink) -> std::unique_ptr<Observer> {
            return std::make_unique<TableObserver<Row>>(context, rocks, sink);
          }};
}

template <class... Row>
auto tables_of(const std::tuple<Row...>*) {
  return std::array{table_of<Row>()...};
}

}  // namespace

std::span<const ResultTable> result_tables() {
  static const auto tables = tables_of(static_cast<const ResultRows*>(nullptr));
  return tables;
}

std::vector<const ResultTable*> tables_with(const TableRocks& rocks) {
  std::vector<const ResultTable*> tables;
  for (const ResultTable& table : result_tables()) {
    if (table.is_wanted(rocks)) tables.push_back(&table);
  }
  return tables;
}

void fill(EndpointRow& row, const TableContext& context, const RockRecord& record) {
  const RockOutcome& outcome = record.outcome;
  const Runout way = runout(outcome, context.runout_frame);
  row.rock = record.rock;
  row.seeder = context.seeders[record.seeder.index];
  row.position_m = coordinates(context.frame.global_from_local(outcome.end.position));
  row.runout_xy_m = way.plan;
  row.runout_z_m = way.drop;
  row.runout_total_m = way.total;
  row.lateral_m = way.lateral;
  row.time_s = outcome.end.time;
  row.events = static_cast<std::uint64_t>(outcome.events);
  row.end_reason = outcome.reason;
  row.ground = outcome.ground ? context.materials[outcome.ground->index] : "";
  row.mass_kg = record.body.mass;
  row.radius_m = record.body.radius;
  row.max_ke_J = outcome.max_kinetic_energy;
  row.max_bounce_m = outcome.max_bounce;
  row.ensemble = ensemble_in(context, record);
  row.a_m = row.b_m = row.c_m = row.short_axis_share = std::nullopt;
  if (!record.block) return;
  row.a_m = record.block->axes.x();
  row.b_m = record.block->axes.y();
  if (record.block->is_section()) return;
  row.c_m = record.block->axes.z();
  row.short_axis_share = record.block->short_axis_share;
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
  row.qw = row.qx = row.qy = row.qz = std::nullopt;
  if (!seen.orientation) return;
  const double w = seen.orientation->w(), sign = w < 0 ? -1 : 1;  // both signs are the same orientation
  const Vec3 v = sign * seen.orientation->xyz();
  row.qw = sign * w;
  row.qx = v.x();
  row.qy = v.y();
  row.qz = v.z();
}

void fill(ImpactRow& row, const TableContext& context, const RockRecord& record, std::uint64_t number,
          const Impact& impact) {
  const auto kinetic = [&](const Motion& motion) {
    return translational_energy(record.body, motion) + rotational_energy(record.body, motion);
  };
  row.rock = record.rock;
  row.impact = number;
  row.time_s = impact.before.time;
  row.position_m = coordinates(context.frame.global_from_local(impact.before.position));
  row.velocity_in_m_s = coordinates(impact.before.velocity);
  row.spin_in_rad_s = coordinates(impact.before.spin);
  row.velocity_out_m_s = coordinates(impact.after.velocity);
  row.spin_out_rad_s = coordinates(impact.after.spin);
  row.normal = coordinates(impact.normal);
  row.struck_normal = coordinates(impact.struck_normal);
  row.ground = context.materials[impact.ground.index];
  row.facet = context.parts != nullptr ? context.parts->of(impact.source) : impact.source;
  row.ke_in_J = kinetic(impact.before);
  row.ke_out_J = kinetic(impact.after);
}

void fill(HitRow& row, const TableContext& context, const RockRecord& record, const Passage& hit) {
  row.barrier = context.barriers[hit.barrier.index];
  row.rock = record.rock;
  row.time_s = hit.motion.time;
  row.position_m = coordinates(context.frame.global_from_local(hit.motion.position));
  row.impact_height_m = hit.height;
  row.velocity_m_s = coordinates(hit.motion.velocity);
  row.angle_deg = hit.angle() * 180 / std::numbers::pi;
  row.ke_translational_J = translational_energy(record.body, hit.motion);
  row.ke_rotational_J = rotational_energy(record.body, hit.motion);
  row.ke_total_J = row.ke_translational_J + row.ke_rotational_J;
  row.outcome = hit.outcome;
  row.ensemble = ensemble_in(context, record);
  row.top_height_m = top_over(hit.lowest, hit.half_height_of(record.body.radius));
}

}  // namespace talus
