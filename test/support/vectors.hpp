#pragma once
// Small vector files for tests.

#ifdef TALUS_HAS_GDAL

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/import/vector_file.hpp"

namespace talus::testing_tools {

/// A request for polygons only.
inline const VectorRequest polygons{.kinds = {ShapeKind::polygon}};

/// A feature as well-known text and the value of the layer's attribute.
using WrittenFeature = std::pair<std::string, std::string>;

/// Adds a layer with one text attribute (empty values are null) and any geometries to a GeoPackage, which is created if
/// needed.
inline void add_layer(const std::filesystem::path& file, const std::string& layer, const std::string& crs_name,
                      const std::string& attribute, const std::vector<WrittenFeature>& features) {
  const GdalMessages gdal(GdalFiles::in_folder(file.parent_path()));
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  ASSERT_NE(driver, nullptr);
  GDALDatasetUniquePtr dataset(std::filesystem::exists(file)
                                   ? GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE)
                                   : driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  ASSERT_TRUE(dataset);
  OGRSpatialReference crs;
  if (!crs_name.empty()) {
    ASSERT_EQ(crs.SetFromUserInput(crs_name.c_str()), OGRERR_NONE);
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer* made = dataset->CreateLayer(layer.c_str(), crs_name.empty() ? nullptr : &crs, wkbUnknown, nullptr);
  ASSERT_NE(made, nullptr);
  OGRFieldDefn field(attribute.c_str(), OFTString);
  ASSERT_EQ(made->CreateField(&field), OGRERR_NONE);
  for (const auto& [text, value] : features) {
    OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(made->GetLayerDefn()));
    if (!value.empty()) feature->SetField(attribute.c_str(), value.c_str());
    if (!text.empty()) {
      OGRGeometry* geometry = nullptr;
      ASSERT_EQ(OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &geometry), OGRERR_NONE) << text;
      feature->SetGeometryDirectly(geometry);
    }
    ASSERT_EQ(made->CreateFeature(feature.get()), OGRERR_NONE);
  }
}

}  // namespace talus::testing_tools

#endif
