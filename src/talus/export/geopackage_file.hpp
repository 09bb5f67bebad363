#pragma once
// A GeoPackage that appears under its name when it is complete. For files that are built with GDAL only.

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "talus/gdal/gdal_raster.hpp"

namespace talus {

struct GeoField {
  std::string name;
  OGRFieldType type = OFTReal;  // or OFTInteger64, OFTString
};

/// Written as `NAME.part` next to its final place, and removed if it is not committed. Its bytes depend on its content
/// only: the time of the last change, which the format requires, is the beginning of 1970. Every failure throws
/// BadInput that names the file.
class GeoPackageFile {
 public:
  /// `crs_wkt`: coordinate system of all layers; empty if unknown, which gives an undefined Cartesian one.
  GeoPackageFile(std::filesystem::path path, const std::string& crs_wkt);
  GeoPackageFile(const GeoPackageFile&) = delete;
  GeoPackageFile& operator=(const GeoPackageFile&) = delete;
  ~GeoPackageFile();

  /// Adds a layer of points or lines in space.
  [[nodiscard]] OGRLayer& add_layer(const char* name, OGRwkbGeometryType type, const char* meaning,
                                    std::span<const GeoField> fields);
  void add(OGRLayer& layer, OGRFeature& feature);
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_, part_;
  GdalMessages messages_;
  // Options of this thread, until the file is closed.
  CPLConfigOptionSetter date_{"OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z", false};
  CPLConfigOptionSetter journal_{"OGR_SQLITE_JOURNAL", "OFF", false};
  CPLConfigOptionSetter synchronous_{"OGR_SQLITE_SYNCHRONOUS", "OFF", false};
  OGRSpatialReference crs_;
  GDALDatasetUniquePtr dataset_;
  bool is_committed_ = false;
};

}  // namespace talus
