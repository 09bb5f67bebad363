#ifdef TALUS_HAS_GDAL

#include "talus/layers/layer_raster.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "talus/gdal/gdal_open.hpp"
#include "talus/gdal/raster_crs.hpp"

namespace talus {

namespace {

/// A raster of this many cells takes some seconds to read.
constexpr double many_cells = 3e8;

/// Heights are not transformed; x is to the east.
OGRSpatialReference on_plan(OGRSpatialReference crs) {
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.IsCompound()) crs.StripVertical();
  crs.DemoteTo2D(nullptr);
  return crs;
}

std::string place_command(const RasterProblems& problems) {
  return problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif");
}

}  // namespace

LayerRaster::LayerRaster(const std::filesystem::path& file, const TerrainOnPlan& terrain) : problems_(file) {
  dataset_ = open_raster(messages_, problems_, GdalKind::picture);
  const bool is_placed = read_geotransform(*dataset_, geotransform_, problems_);
  if (GDALDataTypeIsComplex(dataset_->GetRasterBand(1)->GetRasterDataType()))
    problems_.refuse("has complex numbers in band 1", "they have no colour");
  if (is_placed) find_crs(terrain);
  problems_.throw_if_any();
  const PlanArea whole = extent();
  area_ = whole.common(terrain.area);
  if (area_.is_empty()) {
    const PlanArea swapped{{whole.low.y(), whole.low.x()}, {whole.high.y(), whole.high.x()}};
    problems_.stop("does not lie over the terrain",
                   fmt::format("it covers {}; the terrain {}", in_words(whole), in_words(terrain.area)),
                   own_crs_.empty()                ? "Assign its coordinate system: " + place_command(problems_)
                   : swapped.touches(terrain.area) ? "With x and y swapped it would"
                                                   : "Assign the right coordinate system: " + place_command(problems_));
  }
  const double cells = static_cast<double>(dataset_->GetRasterXSize()) * dataset_->GetRasterYSize();
  const Vec2 size = whole.size();
  cell_ = std::sqrt(size.x() * size.y() / cells);
  if (cells > many_cells && dataset_->GetRasterBand(1)->GetOverviewCount() == 0) {
    problems_.warn(fmt::format("has {:.0f} million cells and no overviews", cells / 1e6), "it is read slowly",
                   fmt::format("Add them: gdaladdo -r average {}", shell_word(file.string())));
  }
}

void LayerRaster::find_crs(const TerrainOnPlan& terrain) {
  const OGRSpatialReference* known = dataset_->GetSpatialRef();
  if (known && refuse_files_in_crs(*known, problems_, "Assign one without it: " + place_command(problems_))) return;
  if (known && known->IsEmpty()) known = nullptr;
  if (terrain.crs_wkt.empty()) {
    if (!known) return;
    const double unit = known->IsGeographic() ? 0 : known->GetLinearUnits();
    if (std::abs(unit - 1) <= 1e-9) return;
    problems_.refuse(
        known->IsGeographic() ? "is in degrees" : "is not in metres",
        fmt::format("its coordinate system is {}, and that of the terrain is not known", name_of(*known)),
        "Set terrain.crs, or project the file: " + problems_.command("gdalwarp -t_srs EPSG:XXXX", "_metres.tif"));
    return;
  }
  if (!known) {
    problems_.warn("has no coordinate system", "that of the terrain is assumed",
                   "Assign it: " + place_command(problems_));
    return;
  }
  OGRSpatialReference to;
  to.importFromWkt(terrain.crs_wkt.c_str());
  own_crs_ = wkt_of(on_plan(*known));
  terrain_crs_ = wkt_of(on_plan(to));
}

/// The rectangle around the raster, in the terrain's coordinates.
PlanArea LayerRaster::extent() const {
  PlanArea whole{Vec2::all(std::numeric_limits<double>::infinity()),
                 Vec2::all(-std::numeric_limits<double>::infinity())};
  const double* const t = geotransform_;
  for (const double column : {0.0, static_cast<double>(dataset_->GetRasterXSize())}) {
    for (const double row : {0.0, static_cast<double>(dataset_->GetRasterYSize())}) {
      const Vec2 corner(t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]);
      whole = {whole.low.min(corner), whole.high.max(corner)};
    }
  }
  if (own_crs_.empty() || own_crs_ == terrain_crs_) return whole;
  constexpr int points_of_side = 21;
  OGRSpatialReference from, to;
  from.importFromWkt(own_crs_.c_str());
  to.importFromWkt(terrain_crs_.c_str());
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&from, &to));
  PlanArea placed;
  if (!change || !change->TransformBounds(whole.low.x(), whole.low.y(), whole.high.x(), whole.high.y(), &placed.low.x(),
                                          &placed.low.y(), &placed.high.x(), &placed.high.y(), points_of_side)) {
    return {Vec2{}, Vec2{}};  // lies nowhere
  }
  return placed;
}

}  // namespace talus

#endif
