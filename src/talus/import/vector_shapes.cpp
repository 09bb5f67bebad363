#ifdef TALUS_HAS_GDAL

#include "talus/import/vector_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "talus/import/filler_values.hpp"
#include "talus/import/raster_file.hpp"

namespace talus {

namespace {

constexpr std::uint64_t most_vertices = 250'000'000;
constexpr std::size_t most_reported = 5;  // of each fault, so that others are not hidden

/// The largest gap between the ends of a polygon's rings, on plan or in space; nullopt if all are closed.
std::optional<double> widest_gap(const OGRGeometry& geometry, bool in_space) {
  std::optional<double> widest;
  const auto measure = [&](const OGRPolygon& polygon) {
    for (const OGRLinearRing* ring : polygon) {
      const int last = ring->getNumPoints() - 1;
      if (last < 0) continue;
      const double gap = std::hypot(ring->getX(last) - ring->getX(0), ring->getY(last) - ring->getY(0),
                                    in_space ? ring->getZ(last) - ring->getZ(0) : 0);
      if (gap > 0) widest = std::max(gap, widest.value_or(0));
    }
  };
  if (wkbFlatten(geometry.getGeometryType()) == wkbMultiPolygon) {
    for (const OGRPolygon* part : *geometry.toMultiPolygon()) measure(*part);
  } else {
    measure(*geometry.toPolygon());
  }
  return widest;
}

OGRPolygon polygon_within(const OGRLineString& closed) {
  OGRLinearRing ring;
  ring.addSubLineString(&closed);
  OGRPolygon polygon;
  polygon.addRing(&ring);
  return polygon;
}

std::string_view word(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::point:
      return "point";
    case ShapeKind::line:
      return "line";
    case ShapeKind::polygon:
      break;
  }
  return "polygon";
}

/// Whether a polygon is valid, and if not, why: GEOS, behind OGRGeometry::IsValid(), reports the reason only as a
/// warning.
class Validity {
 public:
  explicit Validity(const OGRGeometry& geometry) {
    CPLPushErrorHandlerEx(&note, this);
    is_valid_ = geometry.IsValid();
    CPLPopErrorHandler();
    if (!is_valid_ && reason_.empty()) reason_ = "GEOS gives no reason";
  }
  [[nodiscard]] bool is_valid() const { return is_valid_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  static void note(CPLErr, CPLErrorNum, const char* message) {
    std::string& reason = static_cast<Validity*>(CPLGetErrorHandlerUserData())->reason_;
    if (!reason.empty() || !*message) return;
    reason = message;
    reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
  }
  bool is_valid_ = false;
  std::string reason_;
};

}  // namespace

std::string ogr2ogr(std::string_view options, const std::filesystem::path& file, std::string_view ending) {
  std::filesystem::path made = file;
  made.replace_filename(file.stem().string() + std::string(ending));
  return fmt::format("ogr2ogr {} {} {}", options, shell_word(made.string()), shell_word(file.string()));
}

VectorShapes::VectorShapes(const VectorRequest& request, const OGRSpatialReference* crs, bool is_drawing,
                           RasterProblems& problems)
    : request_(request), problems_(problems), is_drawing_(is_drawing) {
  if (crs) {
    is_geographic_ = crs->IsGeographic();
    crs_name_ = name_of(*crs);
    if (request.heights_are_used) height_fault_ = fault_of_heights(*crs);
  }
  const auto project = [&](const OGRSpatialReference& from) {
    const std::string keeping = option_to_keep_heights(from);
    return ogr2ogr(
        fmt::format("{}{}-t_srs EPSG:XXXX", keeping.substr(keeping.empty() ? 0 : 1), keeping.empty() ? "" : " "),
        problems.file(), "_metres.gpkg");
  };
  if (!request.terrain_crs_wkt.empty()) {
    find_transformation(crs);
  } else if (is_geographic_) {
    problems.refuse(
        "is in degrees",
        fmt::format("{} is a geographic coordinate system, and that of the terrain is not known", crs_name_),
        "Project it: " + project(*crs));
  } else if (const char* unit = nullptr; crs && std::abs(crs->GetLinearUnits(&unit) - 1) > 1e-9) {
    problems.refuse("is not in metres",
                    fmt::format("the unit of {} is {}, and the coordinate system of the terrain is not known",
                                crs_name_, unit && *unit ? unit : "an unnamed unit"),
                    "Project it: " + project(*crs));
  }
}

void VectorShapes::find_transformation(const OGRSpatialReference* crs) {
  const std::string assign = ogr2ogr("-a_srs EPSG:XXXX", problems_.file(), "_placed.gpkg");
  if (!crs) {
    problems_.warn("has no coordinate system", "that of the terrain is assumed", "Assign it: " + assign);
    return;
  }
  // The driver sets the order of the file's axes; the terrain's is easting first. Heights are not transformed.
  OGRSpatialReference from = *crs, to;
  to.importFromWkt(request_.terrain_crs_wkt.c_str());
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  for (OGRSpatialReference* one : {&from, &to}) {
    if (one->IsCompound()) one->StripVertical();
    one->DemoteTo2D(nullptr);
  }
  terrain_crs_name_ = name_of(to);
  if (from.IsSame(&to)) return;
  to_terrain_.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (to_terrain_) return;
  problems_.refuse(fmt::format("is in {}", crs_name_),
                   fmt::format("there is no transformation from it to {}, that of the terrain", terrain_crs_name_),
                   "Assign the right one: " + assign);
}

void VectorShapes::add(const OGRGeometry& geometry, VectorFeature& feature) {
  if (geometry.IsEmpty()) return;
  has_heights_ = has_heights_ || feature.has_z;
  if (geometry.hasCurveGeometry()) {
    const std::unique_ptr<OGRGeometry> chords(geometry.getLinearGeometry());
    if (chords) return add(*chords, feature);
  }
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
    case wkbTriangle:
      if (accepts(ShapeKind::polygon, feature) && is_valid(geometry, feature))
        add_polygon(*geometry.toPolygon(), feature);
      return;
    case wkbMultiPolygon:
      if (!accepts(ShapeKind::polygon, feature) || !is_valid(geometry, feature)) return;
      for (const OGRPolygon* part : *geometry.toMultiPolygon()) add_polygon(*part, feature);
      return;
    case wkbTIN:
    case wkbPolyhedralSurface:
      for (const OGRPolygon* part : *geometry.toPolyhedralSurface()) add(*part, feature);
      return;
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, feature);
      return;
    case wkbLineString: {
      const OGRLineString& line = *geometry.toLineString();
      if (is_drawing_ && line.get_IsClosed() && !reads(ShapeKind::line) && reads(ShapeKind::polygon)) {
        add(polygon_within(line), feature);
      } else if (accepts(ShapeKind::line, feature)) {
        add_line(ShapeKind::line, line, feature);
      }
      return;
    }
    case wkbPoint: {
      OGRLineString one;
      one.addPoint(geometry.toPoint());
      if (accepts(ShapeKind::point, feature)) add_line(ShapeKind::point, one, feature);
      return;
    }
    default:
      note(other_kind, feature, fmt::format("is a {}", geometry.getGeometryName()));
  }
}

bool VectorShapes::reads(ShapeKind kind) const {
  const auto& kinds = request_.kinds;
  return kinds.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool VectorShapes::accepts(ShapeKind kind, const VectorFeature& feature) {
  if (reads(kind)) return true;
  note(other_kind, feature, fmt::format("is a {}", word(kind)));
  return false;
}

bool VectorShapes::is_valid(const OGRGeometry& geometry, const VectorFeature& feature) {
  // GEOS, which checks the rest, does not accept open rings.
  if (const auto apart = widest_gap(geometry, request_.polygons_are_in_space)) {
    note(open_ring, feature, fmt::format("its ends are {:.4g} apart", *apart));
    return false;
  }
  if (request_.polygons_are_in_space) return true;  // checked when they are triangulated in their planes
  const Validity validity(geometry);
  if (!validity.is_valid()) note(invalid, feature, validity.reason());
  return validity.is_valid();
}

void VectorShapes::add_line(ShapeKind kind, const OGRLineString& line, VectorFeature& feature) {
  auto vertices = placed(line, feature);
  if (!vertices) return;
  has_parts_ = true;
  feature.parts.push_back({kind, {std::move(*vertices)}});
}

void VectorShapes::add_polygon(const OGRPolygon& polygon, VectorFeature& feature) {
  VectorShape shape{ShapeKind::polygon, {}};
  for (const OGRLinearRing* ring : polygon) {
    auto vertices = placed(*ring, feature);
    if (!vertices) return;
    if (vertices->empty()) continue;
    vertices->pop_back();  // repeats the first: rings of valid polygons are closed
    shape.lists.push_back(std::move(*vertices));
  }
  if (shape.lists.empty()) return;
  has_parts_ = true;
  feature.parts.push_back(std::move(shape));
}

std::optional<std::vector<Vec3>> VectorShapes::placed(const OGRLineString& line, const VectorFeature& feature) {
  const auto count = static_cast<std::size_t>(line.getNumPoints());
  vertices_ += count;
  if (vertices_ > most_vertices) {
    problems_.stop(fmt::format("has more than {} vertices", most_vertices), "Talus reads no more",
                   "Cut it to the slope: " + ogr2ogr("-spat WEST SOUTH EAST NORTH", problems_.file(), "_slope.gpkg"));
  }
  std::vector<double> x(count), y(count);
  std::vector<Vec3> vertices(count);
  const auto at = [&](std::size_t i) {
    const int number = static_cast<int>(i);
    return fmt::format("({:.10g}, {:.10g})", line.getX(number), line.getY(number));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const int number = static_cast<int>(i);
    x[i] = line.getX(number);
    y[i] = line.getY(number);
    double z = feature.has_z ? line.getZ(number) : 0;
    if (!request_.heights_are_used && !std::isfinite(z)) z = 0;
    vertices[i] = Vec3(x[i], y[i], z);
    if (!vertices[i].is_finite()) {
      note(not_finite, feature, fmt::format("has the coordinates ({:.10g}, {:.10g}, {:.10g})", x[i], y[i], z));
      return std::nullopt;
    }
    if (request_.heights_are_used && (z < lowest_elevation_m || z > highest_elevation_m)) {
      note(bad_height, feature, fmt::format("has the height {:.10g} at {}", z, at(i)));
      return std::nullopt;
    }
    if (is_geographic_ && (std::abs(x[i]) > 360 || std::abs(y[i]) > 90)) {
      note(not_degrees, feature, "is at " + at(i));
      return std::nullopt;
    }
  }
  if (!to_terrain_) {
    note_missing_height(vertices, feature);
    return vertices;
  }
  std::vector<int> is_placed(count, FALSE);
  to_terrain_->Transform(static_cast<int>(count), x.data(), y.data(), nullptr, is_placed.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_placed[i] || !std::isfinite(x[i]) || !std::isfinite(y[i])) {
      note(without_place, feature, "is at " + at(i));
      return std::nullopt;
    }
    vertices[i] = {x[i], y[i], vertices[i].z()};
  }
  note_missing_height(vertices, feature);
  return vertices;
}

void VectorShapes::note_missing_height(std::span<const Vec3> line, const VectorFeature& feature) {
  // Faces may be of any shape.
  if (!request_.heights_are_used || request_.polygons_are_in_space || !feature.has_z) return;
  const auto vertex = vertex_without_height(line);
  if (!vertex || ++missing_heights_.count > 1) return;
  const Vec3& p = line[*vertex];
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& other : line) {
    if (other.z() == p.z()) continue;
    low = std::min(low, other.z());
    high = std::max(high, other.z());
  }
  missing_heights_.first.push_back(
      {fmt::format("feature {} has the height {:.10g} at ({:.10g}, {:.10g})", feature.id, p.z(), p.x(), p.y()),
       low == high ? fmt::format("its other vertices lie at {:.10g} m", low)
                   : fmt::format("its other vertices lie from {:.10g} to {:.10g} m", low, high)});
}

void VectorShapes::note(Fault fault, const VectorFeature& feature, std::string what) {
  Faulty& faulty = faulty_[fault];
  if (++faulty.count <= most_reported) {
    faulty.first.push_back({fmt::format("feature {}", feature.id), std::move(what)});
  }
}

void VectorShapes::report() {
  if (height_fault_ && has_heights_) {
    problems_.refuse(height_fault_->what, height_fault_->why,
                     "Transform it to one with heights in metres: " +
                         ogr2ogr("-t_srs EPSG:XXXX+XXXX", problems_.file(), "_metres.gpkg"));
  }
  if (missing_heights_.count > 0) {
    const auto& [what, why] = missing_heights_.first.front();
    const std::uint64_t more = missing_heights_.count - 1;
    problems_.warn(
        what + (more == 0 ? ""
                          : fmt::format(", and {} more {} such heights", more, more == 1 ? "line has" : "lines have")),
        why + "; the height seems to be missing", "Give the vertex its height, or remove it");
  }
  std::string kinds;
  for (const ShapeKind kind : request_.kinds) kinds += fmt::format("{}{}s", kinds.empty() ? "" : " or ", word(kind));
  const std::string assign = "Assign the right one: " + ogr2ogr("-a_srs EPSG:XXXX", problems_.file(), "_placed.gpkg");
  for (std::size_t fault = 0; fault < fault_count; ++fault) {
    const Faulty& faulty = faulty_[fault];
    if (fault == other_kind && faulty.count > 0 && is_drawing_ && has_parts_) {
      problems_.warn(fmt::format("{} shapes are left out", faulty.count),
                     fmt::format("only {} are read; {} {}", kinds, faulty.first[0][0], faulty.first[0][1]));
      continue;
    }
    for (const auto& [feature, what] : faulty.first) {
      std::string why, hint;
      switch (fault) {
        case other_kind:
          why = kinds.empty() ? "Talus reads points, lines and polygons" : "expected " + kinds;
          if (is_drawing_ && reads(ShapeKind::polygon) && !reads(ShapeKind::line))
            hint = "A closed line is read as a polygon";
          break;
        case open_ring:
          problems_.refuse(feature + " is not closed", what, "Repeat its first vertex at its end");
          continue;
        case invalid:
          problems_.refuse(feature + " is not a valid polygon", what,
                           "Repair it: " + ogr2ogr("-makevalid", problems_.file(), "_valid.gpkg"));
          continue;
        case not_finite:
          why = "coordinates must be finite";
          break;
        case bad_height:
          why = fmt::format("heights must be between {:g} and {:g} m", lowest_elevation_m, highest_elevation_m);
          break;
        case not_degrees:
          why = fmt::format("{} is in degrees", crs_name_);
          hint = assign;
          break;
        default:
          why =
              fmt::format("it cannot be transformed from {} to {}, that of the terrain", crs_name_, terrain_crs_name_);
          hint = assign;
      }
      problems_.refuse(feature + " " + what, why, hint);
    }
    if (faulty.count > faulty.first.size()) {
      problems_.refuse(fmt::format("{} more shapes have this problem", faulty.count - faulty.first.size()), "");
    }
  }
}

}  // namespace talus

#endif
