#pragma once
// Reading the rasters of a folder as terrain and as classes.

#ifdef TALUS_HAS_GDAL

#include <string>
#include <vector>

#include "support/rasters.hpp"
#include "talus/import/class_raster.hpp"
#include "talus/import/raster_file.hpp"

namespace talus::testing_tools {

/// The cells of a default RasterSpec in the order of a RasterGrid.
inline const std::vector<float> from_the_south{9, 10, 11, 12, 5, 6, 7, 8, 1, 2, 3, 4};

class RasterReading : public RasterFolder {
 protected:
  RasterFile read(const std::string& name, const ProjectCrs& crs = {}) {
    warnings_ = Problems{};
    return read_raster_file(path(name), warnings_, crs);
  }
  RasterFile read(const RasterSpec& spec) {
    make("dem.tif", spec);
    return read("dem.tif");
  }
  [[nodiscard]] std::string refusal(const std::string& name, const ProjectCrs& crs = {}) {
    return refusal_of([&] { static_cast<void>(read(name, crs)); });
  }
  [[nodiscard]] std::string refusal(const RasterSpec& spec) {
    make("dem.tif", spec);
    return refusal("dem.tif");
  }
  [[nodiscard]] std::string refusal_as_classes(const std::string& name) {
    warnings_ = Problems{};
    return refusal_of([&] { const ClassRaster classes(path(name), "", warnings_); });
  }
};

}  // namespace talus::testing_tools

#endif
