#include "talus/import/raster_file.hpp"

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include <optional>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/raster_band.hpp"
#include "talus/import/raster_checks.hpp"

namespace talus {

namespace {

/// The coordinate system of the file; if it has none on a map, that of the project.
std::optional<OGRSpatialReference> crs_of(GDALDataset& dataset, const ProjectCrs& project_crs, GdalMessages& messages,
                                          RasterProblems& problems, bool& own_is_local) {
  messages.clear();
  const OGRSpatialReference* own = dataset.GetSpatialRef();
  if (own == nullptr && messages.has_failure()) {
    problems.stop("has a coordinate system that cannot be read", messages.failure());
  }
  if (own && is_local(*own) && !project_crs.crs.is_known()) {
    check_terrain_crs(*own, std::nullopt, problems);  // its unit
    own_is_local = true;
  } else if (own && !own->IsEmpty()) {
    const SurveyCrs of_file{.wkt = wkt_of(*own), .name = name_of(*own)};
    if (project_crs.is_local || (project_crs.crs.is_known() && !have_same_plan(of_file, project_crs.crs))) {
      problems.refuse(
          fmt::format("is in {}", of_file.name),
          fmt::format("the project sets crs = \"{}\"", project_crs.is_local ? "local" : project_crs.crs.name),
          "Remove crs, or assign the right one to the file: " +
              problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif"));
    }
    return *own;
  }
  OGRSpatialReference crs;
  if (!project_crs.crs.is_known() || crs.importFromWkt(project_crs.crs.wkt.c_str()) != OGRERR_NONE) return std::nullopt;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

}  // namespace

bool can_read_rasters() { return true; }

RasterFile read_raster_file(const std::filesystem::path& path, Problems& warnings, const ProjectCrs& project_crs) {
  GdalMessages messages;
  RasterProblems problems(path);
  const GDALDatasetUniquePtr dataset = open_raster(messages, problems);
  GDALRasterBand& band = *dataset->GetRasterBand(1);

  check_size(*dataset, problems);
  const auto place = placing_of(*dataset, problems);
  bool is_local_file = false;
  const std::optional<OGRSpatialReference> named = crs_of(*dataset, project_crs, messages, problems, is_local_file);
  const bool is_in_local_metres = project_crs.is_local || (is_local_file && !named);
  const OGRSpatialReference* const crs = named ? &*named : nullptr;
  std::optional<Vec2> centre;
  double t[6];
  if (dataset->GetGeoTransform(t) == CE_None) {
    const double i = 0.5 * band.GetXSize(), j = 0.5 * band.GetYSize();
    centre = Vec2(t[0] + t[1] * i + t[2] * j, t[3] + t[4] * i + t[5] * j);
  }
  check_band(band, problems);
  // Before the plan is checked: a projected copy no longer declares the unit of its heights.
  check_unit(band, crs, problems);
  if (place) check_place(*dataset, *place, crs, is_in_local_metres, problems);
  if (crs) check_terrain_crs(*crs, centre, problems);
  problems.throw_if_any();

  RasterFile out;
  if (crs) {
    out.crs_wkt = wkt_of(*crs);
    out.crs_name = name_of(*crs);
  } else if (is_in_local_metres) {
    out.crs_name = "local coordinates";
  } else {
    problems.warn("has no coordinate system",
                  fmt::format("its cells are assumed to be {:.6g} x {:.6g} m", place->dx, place->dy),
                  "Set crs = \"EPSG:XXXX\" in [terrain], or \"local\" for metres that belong to no map");
  }
  if (band.GetRasterDataType() == GDT_Byte) {
    problems.warn("has 8-bit elevations, integers from 0 to 255",
                  "that is typical of a hillshade or another picture, not of a DEM",
                  "Use the raster of elevations that it was made from");
  }
  warn_of_further_bands(*dataset, problems);
  read_band(band, *place, messages, problems, out);
  warnings.append(problems.warnings());
  return out;
}

}  // namespace talus

#else

namespace talus {

bool can_read_rasters() { return false; }

RasterFile read_raster_file(const std::filesystem::path& path, Problems&, const ProjectCrs&) {
  throw BadInput(Problem{.file = path.string(),
                         .where = {},
                         .what = "cannot be read",
                         .why = "this build of Talus has no GDAL",
                         .hint = "Build it with GDAL: cmake --preset release -DTALUS_GDAL=ON"});
}

}  // namespace talus

#endif
