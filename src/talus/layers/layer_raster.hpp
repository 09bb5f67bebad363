#pragma once
// A raster that is to be drawn over the terrain: opened, with its place there. Only for files that are built with GDAL.

#include <string>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/layers/terrain_on_plan.hpp"

namespace talus {

class LayerRaster {
 public:
  /// Throws BadInput with all errors; doubts are in `warnings()`.
  LayerRaster(const std::filesystem::path& file, const TerrainOnPlan& terrain);

  [[nodiscard]] GDALDataset& dataset() { return *dataset_; }
  [[nodiscard]] GdalMessages& messages() { return messages_; }
  [[nodiscard]] RasterProblems& problems() { return problems_; }
  [[nodiscard]] const Problems& warnings() const { return problems_.warnings(); }
  /// What it has in common with the terrain.
  [[nodiscard]] const PlanArea& area() const { return area_; }
  /// About the size of a cell on the terrain [m].
  [[nodiscard]] double cell() const { return cell_; }
  /// On plan, as WKT: that of the file and that of the terrain; both empty if one is not known.
  [[nodiscard]] const std::string& own_crs() const { return own_crs_; }
  [[nodiscard]] const std::string& terrain_crs() const { return terrain_crs_; }

 private:
  void find_crs(const TerrainOnPlan& terrain);
  [[nodiscard]] PlanArea extent() const;

  GdalMessages messages_;  // must outlive the dataset
  RasterProblems problems_;
  GDALDatasetUniquePtr dataset_;
  double geotransform_[6] = {};
  PlanArea area_;
  double cell_ = 1;
  std::string own_crs_, terrain_crs_;
};

}  // namespace talus
