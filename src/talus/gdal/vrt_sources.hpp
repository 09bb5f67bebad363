#pragma once
// Virtual rasters (VRT): a text that names other rasters, of which it is a mosaic. For files that are built with
// GDAL only.

#include "talus/gdal/gdal_raster.hpp"

namespace talus {

/// Brings all rasters that a VRT names into reach. They have to be ordinary files of the formats that Talus reads, in
/// the VRT's own folder or below it, and they may be VRTs themselves. Refuses a VRT that names anything else: an
/// address, a file elsewhere (also by a link), bytes of a file that is not a raster, a way of computing.
/// `problems`: of the VRT, which is in reach already. Throws BadInput.
void bring_sources_into_reach(GdalMessages& messages, RasterProblems& problems);

/// How GDAL calls the format of a raster that is in reach, as its first bytes say; empty where it is none that is read.
[[nodiscard]] std::string driver_of_raster(const std::string& name);

}  // namespace talus
