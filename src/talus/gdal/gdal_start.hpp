#pragma once
// GDAL as Talus uses it: a few formats, only the files in reach (gdal_files.hpp), and no network. Only for files that
// are built with GDAL.

#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace talus {

/// A picture is a raster that may also be of a format without elevations (PNG, JPEG).
enum class GdalKind { raster, picture, vector };

/// A format that Talus reads. A file's contents decide its format.
struct GdalFormat {
  const char* driver;  // GDAL's name
  const char* name;    // the common name
};

[[nodiscard]] std::span<const GdalFormat> formats_read(GdalKind kind);
/// The common names: "GeoTIFF, Esri ASCII grid (.asc) and VRT".
[[nodiscard]] std::string names_of_formats(GdalKind kind);

/// Must be called before GDAL is used; later calls do nothing. Registers only the drivers of the formats above and the
/// those that write maps (COG) or rasters in memory (MEM), whatever plugins and settings the machine has. Descriptions
/// of data elsewhere (WMS, WFS, OGR's virtual layers, databases) are not read, not even if another file refers to them.
/// GDAL and PROJ do not use the network.
void start_gdal();

/// During its lifetime, bounds the SQL queries of this thread: a view in a GeoPackage may run for ever.
class QueryLimit {
 public:
  QueryLimit();
  QueryLimit(const QueryLimit&) = delete;
  QueryLimit& operator=(const QueryLimit&) = delete;
  ~QueryLimit();

  /// Allows queries about as many steps as a database of this size can need. Without it there is no limit.
  void allow_for(std::uint64_t bytes);
  [[nodiscard]] bool is_reached() const { return left_ == 0; }
  /// Counts steps of SQLite's virtual machine; false if there were too many in this thread.
  [[nodiscard]] static bool count(std::uint64_t steps);

 private:
  QueryLimit* before_;
  std::uint64_t left_ = std::numeric_limits<std::uint64_t>::max();  // steps
};

/// GDAL is shared with other code of this process, as in an interpreter of Python: its files and networks stay open to
/// that code. Drivers that it registers are not used by Talus, which names the formats it reads. To be called before
/// start_gdal().
void share_gdal();

}  // namespace talus
