#pragma once
// GDAL as Talus uses it: a few formats, the files in reach (gdal_files.hpp), and no network. For files that are
// built with GDAL only.

#include <span>
#include <string>

namespace talus {

enum class GdalKind { raster, vector };

/// A format that is read. The content of a file decides which one it has.
struct GdalFormat {
  const char* driver;  // as GDAL calls it
  const char* name;    // as people do
};

[[nodiscard]] std::span<const GdalFormat> formats_read(GdalKind kind);
/// Their names: "GeoTIFF, Esri ASCII grid and VRT".
[[nodiscard]] std::string names_of_formats(GdalKind kind);

/// To be called before GDAL is used; does its work once. GDAL knows no drivers but those of the formats above and the
/// one that writes maps (COG), whatever plugins and settings the machine has: what is a description of data elsewhere
/// (WMS, WFS, OGR's virtual layers, databases) is not understood, also where a file that is read names it. No part of
/// GDAL or PROJ reaches the network.
void start_gdal();

}  // namespace talus
