#include "talus/export/vector_out.hpp"

#include "talus/core/problems.hpp"

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "talus/archive/path_arcs.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/export/geopackage_file.hpp"
#include "talus/export/geopackage_rows.hpp"

namespace talus {

namespace {

template <class Value>
constexpr OGRFieldType type_of() {
  if constexpr (std::same_as<Value, std::uint64_t> || std::same_as<Value, std::optional<std::uint64_t>>)
    return OFTInteger64;
  return std::same_as<Value, double> || std::same_as<Value, std::optional<double>> ? OFTReal : OFTString;
}

template <TableRow Row>
std::vector<GeoField> fields_of(std::span<const std::string> of_family = {}) {
  std::vector<GeoField> fields;
  const Row example;
  for_columns<Row>([&](const auto& column) {
    if constexpr (is_family<std::remove_cvref_t<decltype(column)>>) {
      for (const std::string& name : of_family) fields.push_back({name});
    } else {
      fields.push_back({std::string(column.name), type_of<std::remove_cvref_t<decltype(column.in(example))>>()});
    }
  });
  return fields;
}

/// Sets fields one after the other.
class Fields {
 public:
  explicit Fields(OGRLayer& layer) : feature_(layer.GetLayerDefn()) {}
  template <TableRow Row>
  void set(const Row& row) {
    for_columns<Row>([&](const auto& column) {
      if constexpr (is_family<std::remove_cvref_t<decltype(column)>>) {
        for (const std::optional<double>& value : row.*column.member) set(value);
      } else {
        set(column.in(row));
      }
    });
  }
  void set(double x) { feature_.SetField(next_++, x); }
  void set(std::uint64_t x) { feature_.SetField(next_++, static_cast<GIntBig>(x)); }
  void set(const std::string& text) { feature_.SetField(next_++, text.c_str()); }
  void set(EndReason reason) { feature_.SetField(next_++, name(reason)); }
  template <class Value>
  void set(const std::optional<Value>& x) {
    if (x) {
      set(*x);
    } else {
      ++next_;
    }
  }
  void put_at(const OGRGeometry& geometry) { feature_.SetGeometry(&geometry); }
  [[nodiscard]] OGRFeature& feature() { return feature_; }

 private:
  OGRFeature feature_;
  int next_ = 0;
};

OGRPoint point(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

OGRLineString line_along(const std::vector<std::array<double, 3>>& points) {
  OGRLineString line;
  for (const auto& [x, y, z] : points) line.addPoint(x, y, z);
  return line;
}

class Layers {
 public:
  Layers(GeoPackageFile& file, const RunFacts& facts) : file_(file), facts_(facts) {
    add_barriers();
    if (!facts.design_sections.empty()) add_design();
    std::vector<GeoField> fields = fields_of<EndpointRow>();
    fields.push_back({"source", OFTString});
    endpoints_ = &file.add_layer("endpoints", wkbPoint25D, "Where rocks ended", fields);
    const std::vector<GeoField> of_rock = fields_of<RockLayerRow>();
    paths_ = &file.add_layer("paths", wkbLineString25D, "Ways of rocks, arcs of flights included", of_rock);
    if (facts.in_tables.impacts() > 0) {
      std::vector<GeoField> of_impact = fields_of<ImpactRow>();
      of_impact.push_back({"source", OFTString});
      impacts_ = &file.add_layer("impacts", wkbPoint25D, "Where rocks struck the ground", of_impact);
    }
    releases_ = &file.add_layer("releases", wkbPoint25D, "Where the rocks of the layer paths began", of_rock);
  }

  void add_endpoint(const EndpointRow& end) {
    Fields fields(*endpoints_);
    fields.set(end);
    fields.set(facts_.source_of(end.rock));
    fields.put_at(point(end.position_m));
    file_.add(*endpoints_, fields.feature());
  }

  void add_impact(const ImpactRow& impact) {
    Fields fields(*impacts_);
    fields.set(impact);
    fields.set(facts_.source_of(impact.rock));
    fields.put_at(point(impact.position_m));
    file_.add(*impacts_, fields.feature());
  }

  /// The path of the rock that `end` is of.
  void add_path(const Path& path, const EndpointRow& end) {
    OGRLineString line;
    for_points_along(path, geopackage_tolerance_m, [&](const PathPoint& at) {
      const auto& [x, y, z] = at.position_m;
      const int last = line.getNumPoints() - 1;
      // A contact has two rows in one place.
      if (last >= 0 && line.getX(last) == x && line.getY(last) == y && line.getZ(last) == z) return;
      line.addPoint(x, y, z);
    });
    if (line.getNumPoints() == 1) line.addPoint(line.getX(0), line.getY(0), line.getZ(0));  // a line needs two points
    const RockLayerRow row{.rock = end.rock,
                           .seeder = end.seeder,
                           .source = facts_.source_of(end.rock),
                           .end_reason = end.end_reason,
                           .time_s = end.time_s,
                           .events = end.events,
                           .runout_xy_m = end.runout_xy_m,
                           .mass_kg = end.mass_kg,
                           .radius_m = end.radius_m,
                           .max_ke_J = end.max_ke_J,
                           .max_bounce_m = end.max_bounce_m};
    add(*paths_, line, row);
    add(*releases_, point(path.rows.front().position_m), row);
  }

 private:
  template <TableRow Row>
  void add(OGRLayer& layer, const OGRGeometry& geometry, const Row& row) {
    Fields fields(layer);
    fields.set(row);
    fields.put_at(geometry);
    file_.add(layer, fields.feature());
  }

  void add_barriers() {
    std::vector<std::string> names;
    for (const HitQuantity& quantity : hit_quantities) {
      for (const char* part : {"p95", "p99", "max"}) names.push_back(BarrierLayerRow::column(quantity, part));
    }
    OGRLayer& layer = file_.add_layer("barriers", wkbLineString25D,
                                      "Feet of barriers and collectors, with what the rocks ask of them",
                                      fields_of<BarrierLayerRow>(names));
    for (const BarrierFacts& barrier : facts_.barriers) {
      BarrierLayerRow row{.name = barrier.name,
                          .kind = barrier.kind,
                          .height_m = barrier.height_m,
                          .inclination_deg = barrier.inclination_deg,
                          .capacity_kJ = barrier.capacity_kJ,
                          .hits = barrier.hits,
                          .rocks_hit = barrier.rocks_hit,
                          .passed_above = barrier.passed_above,
                          .stopped = barrier.outcomes.stopped,
                          .rebounded = barrier.outcomes.rebounded,
                          .broke_through = barrier.outcomes.broke_through,
                          .passed = barrier.outcomes.passed,
                          .least_clearance_m = barrier.least_clearance_m};
      for (const HitQuantity& quantity : hit_quantities) {
        const Statistics of_hits = barrier.statistics_of(fmt::format("{}_{}", quantity.name, quantity.unit_in_name));
        row.statistics.insert(row.statistics.end(),
                              {of_hits.percentiles.p95, of_hits.percentiles.p99, of_hits.maximum});
      }
      add(layer, line_along(barrier.line_xyz), row);
    }
  }

  void add_design() {
    OGRLayer& layer =
        file_.add_layer("design", wkbLineString25D, "Sections of lines, with what the rocks ask of a barrier there",
                        fields_of<DesignLayerRow>(facts_.design_figures));
    for (const DesignSection& section : facts_.design_sections)
      add(layer, line_along(section.foot_m),
          DesignLayerRow{section.line, section.number, section.from_m, section.to_m, section.rocks, section.share,
                         section.figures});
  }

  GeoPackageFile& file_;
  const RunFacts& facts_;
  OGRLayer *endpoints_, *paths_, *releases_, *impacts_ = nullptr;
};

/// Reads paths.csv in step with the rows of endpoints.csv.
class PathsInStep {
 public:
  PathsInStep(const std::filesystem::path& file, const RunFacts& facts)
      : file_(file),
        reader_(file),
        in_tables_(facts.in_tables),
        chosen_(facts.geopackage_rocks, facts.in_tables.paths()) {
    advance();
  }

  /// The path of this rock if it is shown; nullptr otherwise. Expects rocks in ascending order.
  [[nodiscard]] const Path* of(std::uint64_t rock) {
    if (!has_path_ || reader_.path().rock > rock) return nullptr;
    if (reader_.path().rock < rock) refuse();
    return &reader_.path();
  }
  void advance() {
    has_path_ = reader_.next([&](std::uint64_t rock) { return chosen_.contains(in_tables_.paths_before(rock)); });
  }
  /// Must be called after the last rock.
  void finish() const {
    if (has_path_) refuse();
  }

 private:
  [[noreturn]] void refuse() const {
    throw BadInput(Problem{.file = file_.string(),
                           .what = fmt::format("has the path of rock {}", reader_.path().rock),
                           .why = "endpoints.csv has no such rock after those before it",
                           .hint = "The files are of different runs; run the project again"});
  }

  std::filesystem::path file_;
  PathReader reader_;
  TableRocks in_tables_;
  EvenChoice chosen_;
  bool has_path_ = false;
};

}  // namespace

bool can_write_geopackage() { return true; }

void write_geopackage(const RunFacts& facts, const std::filesystem::path& folder) {
  GeoPackageFile file(folder / geopackage_name, facts.summary.terrain.crs_wkt);
  Layers layers(file, facts);
  PathsInStep paths(folder / PathEventRow::file_name, facts);
  const EvenChoice ends(facts.geopackage_rocks, facts.in_tables.endpoints());
  for (TableReader<EndpointRow> row(folder / EndpointRow::file_name); row.next();) {
    const std::uint64_t rock = row.get<&EndpointRow::rock>();
    if (ends.contains(facts.in_tables.endpoints_before(rock))) layers.add_endpoint(row.whole());
    if (const Path* path = paths.of(rock)) {
      layers.add_path(*path, row.whole());
      paths.advance();
    }
  }
  paths.finish();
  if (facts.in_tables.impacts() > 0) {
    const EvenChoice striking(facts.geopackage_rocks, facts.in_tables.impacts());
    for (TableReader<ImpactRow> row(folder / ImpactRow::file_name); row.next();) {
      if (striking.contains(facts.in_tables.impacts_before(row.get<&ImpactRow::rock>())))
        layers.add_impact(row.whole());
    }
  }
  file.commit();
}

}  // namespace talus

#else

namespace talus {

bool can_write_geopackage() { return false; }

void write_geopackage(const RunFacts&, const std::filesystem::path& folder) {
  throw BadInput(Problem{.file = (folder / geopackage_name).string(),
                         .what = "cannot write this file",
                         .why = "this program was built without GDAL",
                         .hint = "Build it with GDAL, or set geopackage = \"none\""});
}

}  // namespace talus

#endif
