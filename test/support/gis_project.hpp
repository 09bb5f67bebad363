#pragma once
// Projects on a small raster of a mountain side in New Zealand (EPSG:2193), with files next to them.

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "support/rasters.hpp"
#include "support/vectors.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::testing_tools {

/// 60 x 40 cells of 5 m. The slope is flat in the west and steep in the east: z = (x - west)^2 / 200, with a slope at a
/// node of exactly atan((x - west) / 100), also by Horn's differences.
class GisProject : public RasterFolder {
 protected:
  static constexpr double west = 1757000, south = 5917000, cell = 5;
  static constexpr int columns = 60, rows = 40;

  static RasterSpec mountain() {
    RasterSpec spec;
    spec.columns = columns;
    spec.rows = rows;
    spec.crs = "EPSG:2193";
    spec.type = GDT_Float64;
    spec.no_data = -9999;
    spec.geotransform = {west, cell, 0, south + cell * rows, 0, -cell};
    spec.cells.clear();
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const double x = cell * (column + 0.5);
        spec.cells.push_back(x * x / 200);
      }
    }
    return spec;
  }

  /// A rectangle as well-known text, in metres from the south-west corner of the raster.
  static std::string box(double x0, double y0, double x1, double y1) {
    return fmt::format("POLYGON (({0} {1}, {2} {1}, {2} {3}, {0} {3}, {0} {1}))", west + x0, south + y0, west + x1,
                       south + y1);
  }

  /// Writes a GeoPackage with one layer and one attribute.
  void layer(const std::string& file, const std::string& attribute, const std::vector<WrittenFeature>& features,
             const std::string& crs = "EPSG:2193") {
    std::filesystem::remove(path(file));
    add_layer(path(file), "layer", crs, attribute, features);
  }

  [[nodiscard]] Model model(const std::string& text, const project::Overrides& overrides = {}) {
    write("slope.toml", text);
    warnings_ = Problems{};
    project::Reading reading = project::read_project(path("slope.toml"), overrides);
    warnings_ = reading.warnings;
    return project::build_model(reading.project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& text, const project::Overrides& overrides = {}) {
    return refusal_of([&] { static_cast<void>(model(text, overrides)); });
  }
};

}  // namespace talus::testing_tools

#endif
