#include "talus/export/vector_out.hpp"

#include "talus/core/problems.hpp"

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "talus/archive/path_arcs.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/export/geopackage_file.hpp"

namespace talus::io {

namespace {

constexpr std::pair<const char*, const char*> quantities_of_hits[] = {
    {"ke_total", "J"}, {"ke_translational", "J"}, {"impact_height", "m"}, {"velocity", "m_s"}};

template <class Value>
constexpr OGRFieldType type_of(const Value&) {
  if constexpr (std::same_as<Value, std::uint64_t>) {
    return OFTInteger64;
  } else {
    return std::same_as<Value, double> ? OFTReal : OFTString;
  }
}

/// As a column of endpoints.csv.
template <auto member>
GeoField field_of() {
  return {std::string(column_names<EndpointRow>[place_of(member)]), type_of(EndpointRow{}.*member)};
}

/// Sets fields one after the other.
class Row {
 public:
  explicit Row(OGRLayer& layer) : feature_(layer.GetLayerDefn()) {}
  Row& operator<<(double x) {
    feature_.SetField(next_++, x);
    return *this;
  }
  Row& operator<<(std::uint64_t x) {
    feature_.SetField(next_++, static_cast<GIntBig>(x));
    return *this;
  }
  Row& operator<<(const std::string& text) {
    feature_.SetField(next_++, text.c_str());
    return *this;
  }
  Row& operator<<(EndReason reason) {
    feature_.SetField(next_++, name(reason));
    return *this;
  }
  Row& operator<<(const std::optional<double>& x) {
    if (x) return *this << *x;
    ++next_;
    return *this;
  }
  Row& operator<<(const Statistics& values) {
    return *this << values.percentiles.p95 << values.percentiles.p99 << values.maximum;
  }
  void put_at(const OGRGeometry& geometry) { feature_.SetGeometry(&geometry); }
  [[nodiscard]] OGRFeature& feature() { return feature_; }

 private:
  OGRFeature feature_;
  int next_ = 0;
};

OGRPoint point(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

class Layers {
 public:
  Layers(GeoPackageFile& file, const RunFacts& facts) : file_(file), facts_(facts) {
    add_barriers();
    if (!facts.design_sections.empty()) add_design();
    std::vector<GeoField> fields;
    const EndpointRow example;
    for_columns<EndpointRow>([&](const auto& column) {
      fields.push_back({std::string(column.name), type_of(column.in(example))});
    });
    fields.push_back({"source", OFTString});
    endpoints_ = &file.add_layer("endpoints", wkbPoint25D, "Where rocks ended", fields);
    paths_ = &file.add_layer("paths", wkbLineString25D, "Ways of rocks, arcs of flights included", fields_of_a_path);
    releases_ = &file.add_layer("releases", wkbPoint25D, "Where the rocks of the layer paths began", fields_of_a_path);
  }

  void add_endpoint(const EndpointRow& end) {
    Row feature(*endpoints_);
    for_columns<EndpointRow>([&](const auto& column) { feature << column.in(end); });
    feature << facts_.source_of(end.rock);
    feature.put_at(point(end.position_m));
    file_.add(*endpoints_, feature.feature());
  }

  /// The path of the rock that ended so.
  void add_path(const Path& path, const EndpointRow& end) {
    OGRLineString line;
    for_points_along(path, geopackage_tolerance_m, [&](const PathPoint& at) {
      const auto& [x, y, z] = at.position_m;
      const int last = line.getNumPoints() - 1;
      // A contact gives two rows in one place.
      if (last >= 0 && line.getX(last) == x && line.getY(last) == y && line.getZ(last) == z) return;
      line.addPoint(x, y, z);
    });
    if (line.getNumPoints() == 1) line.addPoint(line.getX(0), line.getY(0), line.getZ(0));  // a line has two
    add_with_values(*paths_, line, end);
    add_with_values(*releases_, point(path.rows.front().position_m), end);
  }

 private:
  static inline const std::vector<GeoField> fields_of_a_path{
      field_of<&EndpointRow::rock>(),        field_of<&EndpointRow::seeder>(),      {"source", OFTString},
      field_of<&EndpointRow::end_reason>(),  field_of<&EndpointRow::time_s>(),      field_of<&EndpointRow::events>(),
      field_of<&EndpointRow::runout_xy_m>(), field_of<&EndpointRow::mass_kg>(),     field_of<&EndpointRow::radius_m>(),
      field_of<&EndpointRow::max_ke_J>(),    field_of<&EndpointRow::max_bounce_m>()};

  void add_with_values(OGRLayer& layer, const OGRGeometry& geometry, const EndpointRow& end) {
    Row feature(layer);
    feature << end.rock << end.seeder << facts_.source_of(end.rock) << end.end_reason << end.time_s << end.events
            << end.runout_xy_m << end.mass_kg << end.radius_m << end.max_ke_J << end.max_bounce_m;
    feature.put_at(geometry);
    file_.add(layer, feature.feature());
  }

  void add_barriers() {
    std::vector<GeoField> fields{{"name", OFTString},
                                 {"kind", OFTString},
                                 {"height_m"},
                                 {"inclination_deg"},
                                 {"capacity_kJ"},
                                 {"hits", OFTInteger64},
                                 {"rocks_hit", OFTInteger64},
                                 {"passed_above", OFTInteger64},
                                 {"stopped", OFTInteger64},
                                 {"rebounded", OFTInteger64},
                                 {"broke_through", OFTInteger64},
                                 {"passed", OFTInteger64},
                                 {"least_clearance_m"}};
    for (const auto& [quantity, unit] : quantities_of_hits) {
      for (const char* part : {"p95", "p99", "max"}) fields.push_back({fmt::format("{}_{}_{}", quantity, part, unit)});
    }
    OGRLayer& layer = file_.add_layer("barriers", wkbLineString25D,
                                      "Feet of barriers and collectors, with what the rocks ask of them", fields);
    for (const BarrierFacts& barrier : facts_.barriers) {
      Row feature(layer);
      feature << barrier.name << barrier.kind << barrier.height_m << barrier.inclination_deg << barrier.capacity_kJ
              << barrier.hits << barrier.rocks_hit << barrier.passed_above << barrier.outcomes.stopped
              << barrier.outcomes.rebounded << barrier.outcomes.broke_through << barrier.outcomes.passed
              << barrier.least_clearance_m;
      for (const auto& [quantity, unit] : quantities_of_hits)
        feature << barrier.statistics_of(fmt::format("{}_{}", quantity, unit));
      OGRLineString foot;
      for (const auto& [x, y, z] : barrier.line_xyz) foot.addPoint(x, y, z);
      feature.put_at(foot);
      file_.add(layer, feature.feature());
    }
  }

  void add_design() {
    std::vector<GeoField> fields{
        {"line", OFTString}, {"section", OFTInteger64}, {"from_m"}, {"to_m"}, {"rocks", OFTInteger64}, {"share"}};
    for (const std::string& figure : facts_.design_figures) fields.push_back({figure});
    OGRLayer& layer = file_.add_layer("design", wkbLineString25D,
                                      "Sections of lines, with what the rocks ask of a barrier there", fields);
    for (const DesignSection& section : facts_.design_sections) {
      Row feature(layer);
      feature << section.line << section.number << section.from_m << section.to_m << section.rocks << section.share;
      for (const std::optional<double>& figure : section.figures) feature << figure;
      OGRLineString foot;
      for (const auto& [x, y, z] : section.foot_m) foot.addPoint(x, y, z);
      feature.put_at(foot);
      file_.add(layer, feature.feature());
    }
  }

  GeoPackageFile& file_;
  const RunFacts& facts_;
  OGRLayer *endpoints_, *paths_, *releases_;
};

/// Goes through paths.csv in step with the rows of endpoints.csv.
class PathsInStep {
 public:
  PathsInStep(const std::filesystem::path& file, const RunFacts& facts)
      : file_(file),
        reader_(file),
        in_tables_(facts.in_tables),
        chosen_(facts.geopackage_rocks, facts.in_tables.paths()) {
    go_on();
  }

  /// The path of this rock, if it is one of those that are shown. Rocks come in rising order.
  [[nodiscard]] const Path* of(std::uint64_t rock) {
    if (!has_path_ || reader_.path().rock > rock) return nullptr;
    if (reader_.path().rock < rock) refuse();
    return &reader_.path();
  }
  void go_on() {
    has_path_ = reader_.next([&](std::uint64_t rock) { return chosen_.contains(in_tables_.paths_before(rock)); });
  }
  /// Once all rocks are through.
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
      paths.go_on();
    }
  }
  paths.finish();
  file.commit();
}

}  // namespace talus::io

#else

namespace talus::io {

bool can_write_geopackage() { return false; }

void write_geopackage(const RunFacts&, const std::filesystem::path& folder) {
  throw BadInput(Problem{.file = (folder / geopackage_name).string(),
                         .what = "cannot write this file",
                         .why = "this program was built without GDAL",
                         .hint = "Build it with GDAL, or set geopackage = \"none\""});
}

}  // namespace talus::io

#endif
