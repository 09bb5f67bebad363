#include "talus/import/vector_file.hpp"

#ifdef TALUS_HAS_GDAL

#include <cpl_string.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

#include "talus/core/stop.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/files/names_in_words.hpp"
#include "talus/gdal/gdal_open.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/dxf_entities.hpp"
#include "talus/import/dxf_file.hpp"
#include "talus/import/vector_shapes.hpp"

namespace talus {

namespace {

constexpr std::int64_t most_features = 50'000'000;  // far more than in any survey; a damaged file may declare more

bool is_csv(const std::filesystem::path& file) { return file.extension() == ".csv" || file.extension() == ".CSV"; }

GDALDatasetUniquePtr open_vectors(GdalMessages& messages, RasterProblems& problems) {
  static const char* const columns_of_csv[] = {"GEOM_POSSIBLE_NAMES=WKT,geometry,geom,the_geom",
                                               "X_POSSIBLE_NAMES=x,x_m,east*,lon*",
                                               "Y_POSSIBLE_NAMES=y,y_m,north*,lat*",
                                               "Z_POSSIBLE_NAMES=z,z_m,height*,elev*",
                                               "KEEP_GEOM_COLUMNS=YES",
                                               nullptr};
  return open_with_gdal(GdalKind::vector, messages, problems, is_csv(problems.file()) ? columns_of_csv : nullptr);
}

bool is_dxf(GDALDataset& dataset) { return std::string_view(dataset.GetDriverName()) == "DXF"; }

OGRLayer& layer_of(GDALDataset& dataset, const VectorRequest& request, RasterProblems& problems) {
  const std::string wanted = is_dxf(dataset) ? "" : request.layer;
  std::vector<std::string> names, with_geometry;
  OGRLayer* found = nullptr;
  for (OGRLayer* layer : dataset.GetLayers()) {
    names.emplace_back(layer->GetName());
    if (layer->GetGeomType() == wkbNone) continue;
    with_geometry.push_back(names.back());
    if (wanted.empty() || names.back() == wanted) found = layer;
  }
  if (with_geometry.empty()) {
    problems.stop("has no points, lines or polygons",
                  names.empty() ? "it has no layer" : fmt::format("it has only tables: {}", listed(names)),
                  is_csv(problems.file()) ? "A CSV needs columns x and y, or one named WKT" : "");
  }
  if (!found) {
    const bool is_table = std::find(names.begin(), names.end(), wanted) != names.end();
    problems.stop(
        is_table ? fmt::format("layer \"{}\" has no geometry", wanted) : fmt::format("has no layer \"{}\"", wanted),
        fmt::format("it has {}", listed(with_geometry)), meant(wanted, with_geometry));
  }
  if (wanted.empty() && with_geometry.size() > 1) {
    problems.stop(fmt::format("has {} layers", with_geometry.size()), listed(with_geometry),
                  fmt::format("Choose one: {} = \"{}\"", request.layer_key, with_geometry.front()));
  }
  return *found;
}

std::vector<int> columns_of(OGRLayer& layer, const VectorRequest& request, RasterProblems& problems) {
  const OGRFeatureDefn& definition = *layer.GetLayerDefn();
  std::vector<std::string> names;
  for (int i = 0; i < definition.GetFieldCount(); ++i) names.emplace_back(definition.GetFieldDefn(i)->GetNameRef());
  std::vector<int> columns;
  for (const std::string& attribute : request.choose ? request.choose(names) : request.attributes) {
    columns.push_back(definition.GetFieldIndex(attribute.c_str()));
    if (columns.back() >= 0) continue;
    problems.refuse(fmt::format("layer \"{}\" has no attribute \"{}\"", layer.GetName(), attribute),
                    names.empty() ? "it has none" : fmt::format("it has {}", listed(names)), meant(attribute, names));
  }
  return columns;
}

void check_size(OGRLayer& layer, RasterProblems& problems) {
  const std::int64_t declared = layer.GetFeatureCount(FALSE);
  if (declared <= most_features) return;
  problems.refuse(fmt::format("layer \"{}\" declares {} features", layer.GetName(), declared),
                  fmt::format("Talus reads at most {}", most_features),
                  "Cut it to the slope: " + ogr2ogr("-spat WEST SOUTH EAST NORTH", problems.file(), "_slope.gpkg"));
}

/// GDAL assumes degrees for a GeoJSON whose coordinate system it does not know, as if it had none.
void warn_of_unknown_crs(const OGRSpatialReference* crs, const GdalMessages& messages, RasterProblems& problems) {
  if (messages.failure().find("crs not found") == std::string::npos) return;
  problems.warn("has an unknown coordinate system",
                fmt::format("{} is assumed", crs ? name_of(*crs) : "that of the terrain"),
                "Assign the right one: " + ogr2ogr("-a_srs EPSG:XXXX", problems.file(), "_placed.gpkg"));
}

/// The rectangle of the request in the coordinates of the file, a little larger; nullopt if it has no place there.
std::optional<OGREnvelope> rectangle_in_file(const VectorRequest& request, const OGRSpatialReference* crs) {
  const auto [low, high] = *request.within;
  OGREnvelope found;
  found.MinX = low.x(), found.MinY = low.y(), found.MaxX = high.x(), found.MaxY = high.y();
  if (crs && !request.terrain_crs_wkt.empty()) {
    OGRSpatialReference terrain, file = *crs;
    terrain.importFromWkt(request.terrain_crs_wkt.c_str());
    terrain.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    for (OGRSpatialReference* one : {&terrain, &file}) {
      if (one->IsCompound()) one->StripVertical();
      one->DemoteTo2D(nullptr);
    }
    constexpr int points_of_side = 21;
    const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&terrain, &file));
    if (!change || !change->TransformBounds(low.x(), low.y(), high.x(), high.y(), &found.MinX, &found.MinY, &found.MaxX,
                                            &found.MaxY, points_of_side))
      return std::nullopt;
  }
  const double margin = 0.01 * std::max(found.MaxX - found.MinX, found.MaxY - found.MinY);
  found.MinX -= margin, found.MinY -= margin, found.MaxX += margin, found.MaxY += margin;
  return found;
}

[[noreturn]] void refuse_elsewhere(OGRLayer& layer, const VectorRequest& request, const VectorLayer& read,
                                   RasterProblems& problems) {
  const auto in_words = [](double x0, double y0, double x1, double y1) {
    return fmt::format("x {:.10g} to {:.10g}, y {:.10g} to {:.10g}", x0, x1, y0, y1);
  };
  layer.SetSpatialFilter(nullptr);
  OGREnvelope whole;
  const bool has_extent = layer.GetExtent(&whole, TRUE) == OGRERR_NONE;
  const auto [low, high] = *request.within;
  problems.stop(
      "does not lie over the terrain",
      fmt::format("it covers {}{}; the terrain {}",
                  has_extent ? in_words(whole.MinX, whole.MinY, whole.MaxX, whole.MaxY) : "another area",
                  read.crs_name.empty() ? "" : " in " + read.crs_name, in_words(low.x(), low.y(), high.x(), high.y())),
      read.crs_name.empty() || request.terrain_crs_wkt.empty() ? "Assign its coordinate system, and that of the terrain"
                                                               : "Is its coordinate system the right one?");
}

/// A real number without the zeros that fill the width of a column, as in a DBF.
std::string text_of(OGRFeature& feature, int column) {
  const OGRFieldDefn& field = *feature.GetFieldDefnRef(column);
  if (field.GetType() != OFTReal) return feature.GetFieldAsString(column);
  const double value = feature.GetFieldAsDouble(column);
  return field.GetSubType() == OFSTFloat32 ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
}

/// A point in a drawing may have a label beside it. A drawing of labels alone is read: their heights may be the
/// ground's.
void leave_out_texts(const std::vector<bool>& are_texts, DxfEntities& entities, VectorLayer& read) {
  const auto texts = std::ranges::count(are_texts, true);
  if (texts == 0 || texts == std::ssize(are_texts)) return;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < are_texts.size(); ++k) {
    if (are_texts[k]) continue;
    if (kept != k) read.features[kept] = std::move(read.features[k]);
    ++kept;
  }
  read.features.resize(kept);
  entities.note_texts(static_cast<std::uint64_t>(texts));
}

/// `entities` is null if the file is not a DXF.
void read_features(OGRLayer& layer, const std::vector<int>& columns, DxfEntities* entities, VectorShapes& shapes,
                   VectorLayer& read, GdalMessages& messages, RasterProblems& problems) {
  messages.clear();
  for (const int column : columns) {
    const OGRFieldType type = column < 0 ? OFTString : layer.GetLayerDefn()->GetFieldDefn(column)->GetType();
    read.are_numbers.push_back(type == OFTReal || type == OFTInteger || type == OFTInteger64);
  }
  std::uint64_t seen = 0, without_geometry = 0, not_utf8 = 0;
  std::vector<bool> are_texts;  // of the features of a drawing
  const bool reads_texts =
      entities && std::ranges::find(columns, layer.GetLayerDefn()->GetFieldIndex("Text")) != columns.end();
  layer.ResetReading();
  for (;; ++seen) {
    stop_point(seen);
    const OGRFeatureUniquePtr from(layer.GetNextFeature());
    if (!from) {  // an interrupted query looks like the end of the layer
      stop_point();
      expect_end_of_queries(messages, problems);
    }
    if (messages.has_failure() && entities && (from || is_whole_dxf(problems.file()))) {
      entities->note_unreadable(messages.failure());
      messages.clear();
    }
    if (messages.has_failure()) {
      problems.stop("cannot be read completely",
                    fmt::format("after {} features of layer \"{}\"; {}", seen, read.name, messages.failure()),
                    "Copy it again from its source");
    }
    if (!from) break;
    if (entities && !entities->accepts(*from)) continue;
    const OGRGeometry* geometry = from->GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) {
      ++without_geometry;
      continue;
    }
    VectorFeature feature{.id = from->GetFID(), .has_z = geometry->Is3D() != FALSE, .parts = {}, .values = {}};
    shapes.add(*geometry, feature);
    messages.clear();  // about places that could not be transformed: the shapes record them
    if (feature.parts.empty()) continue;
    for (const int column : columns) {
      const bool has_value = from->IsFieldSetAndNotNull(column);
      feature.values.push_back(has_value ? std::optional(text_of(*from, column)) : std::nullopt);
      if (has_value && !CPLIsUTF8(feature.values.back()->c_str(), -1) && ++not_utf8 == 1) {
        problems.refuse(fmt::format("feature {} has the {} {}", feature.id, from->GetFieldDefnRef(column)->GetNameRef(),
                                    in_quotes(*feature.values.back())),
                        "it is not valid UTF-8",
                        "Convert the file, for example with iconv -f LATIN1 -t UTF-8, or declare its encoding");
      }
    }
    read.features.push_back(std::move(feature));
    if (entities && !reads_texts) are_texts.push_back(DxfEntities::is_text(*from));
  }
  if (entities) leave_out_texts(are_texts, *entities, read);
  shapes.report();
  if (entities) entities->report();
  problems.throw_if_any();
  if (entities) seen = entities->accepted();
  if (read.features.empty()) {
    problems.stop(fmt::format("layer \"{}\" is empty", read.name),
                  entities && entities->left_out() > 0 && seen == 0
                      ? std::string("all entities are in a layout or on hidden layers")
                  : seen == 0 && entities && !entities->unread_kinds().empty()
                      ? fmt::format("it has only entities of kinds that are not read: {}", entities->unread_kinds())
                  : seen == 0                ? std::string("it has no features")
                  : without_geometry == seen ? fmt::format("none of its {} features has a geometry", seen)
                                             : fmt::format("none of its {} features is of a kind that is read", seen));
  }
  if (without_geometry > 0) {
    problems.warn(fmt::format("{} of {} features of layer \"{}\" have no geometry", without_geometry, seen, read.name),
                  "they are left out");
  }
}

}  // namespace

VectorLayer read_vector_file(const std::filesystem::path& path, const VectorRequest& request, Problems& warnings) {
  GdalMessages messages;  // must outlive the dataset, whose destructor may report errors
  RasterProblems problems(path);
  const GDALDatasetUniquePtr dataset = open_vectors(messages, problems);
  OGRLayer& layer = layer_of(*dataset, request, problems);
  VectorLayer read;
  std::optional<DxfEntities> entities;
  if (is_dxf(*dataset)) entities.emplace(layer, request, problems);
  read.name = entities && !entities->layer().empty() ? entities->layer() : layer.GetName();
  const std::vector<int> columns = columns_of(layer, request, problems);
  check_size(layer, problems);
  expect_end_of_queries(messages, problems);
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  // GeoPackages name an absent one "Undefined Cartesian SRS" or "Undefined geographic SRS".
  if (crs && (crs->IsEmpty() || std::string_view(crs->GetName()).starts_with("Undefined "))) crs = nullptr;
  if (crs) {
    const std::string assign = ogr2ogr("-a_srs EPSG:XXXX", problems.file(), "_placed.gpkg");
    if (refuse_files_in_crs(*crs, problems, "Assign one without it: " + assign)) problems.throw_if_any();
    read.crs_is_local = is_local(*crs) && request.terrain_crs_wkt.empty();
    if (read.crs_is_local) {
      check_terrain_crs(*crs, std::nullopt, problems, {[&](const std::string&) { return assign; }, assign});
      crs = nullptr;
    }
  }
  if (crs) {
    read.crs_wkt = wkt_of(*crs);
    read.crs_name = name_of(*crs);
  }
  warn_of_unknown_crs(crs, messages, problems);
  VectorShapes shapes(request, crs, entities.has_value(), problems);
  problems.throw_if_any();
  if (request.within) {
    const auto rectangle = rectangle_in_file(request, crs);
    if (rectangle) layer.SetSpatialFilterRect(rectangle->MinX, rectangle->MinY, rectangle->MaxX, rectangle->MaxY);
    layer.ResetReading();
    const bool has_some = rectangle && OGRFeatureUniquePtr(layer.GetNextFeature());
    expect_end_of_queries(messages, problems);
    if (!has_some) {
      layer.SetSpatialFilter(nullptr);
      layer.ResetReading();
      // An empty layer is refused below.
      if (OGRFeatureUniquePtr(layer.GetNextFeature())) refuse_elsewhere(layer, request, read, problems);
    }
  }
  read_features(layer, columns, entities ? &*entities : nullptr, shapes, read, messages, problems);
  warnings.append(problems.warnings());
  return read;
}

}  // namespace talus

#else

namespace talus {

VectorLayer read_vector_file(const std::filesystem::path& path, const VectorRequest&, Problems&) {
  throw BadInput(Problem{.file = path.string(),
                         .where = {},
                         .what = "cannot be read",
                         .why = "this build of Talus has no GDAL",
                         .hint = "Build it with GDAL: cmake --preset release -DTALUS_GDAL=ON"});
}

}  // namespace talus

#endif
