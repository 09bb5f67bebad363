#pragma once
// The sources of virtual rasters (VRT): texts that describe a mosaic of other rasters. Only for files that are built
// with GDAL.

#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/gdal_start.hpp"

namespace talus {

/// Adds all rasters that a VRT refers to, to the reach of `messages`. They must be ordinary files of the formats that
/// Talus reads, in the VRT's own folder or below it, and may be VRTs themselves. Refuses a VRT that refers to anything
/// else: an address, a file elsewhere (also by a link), bytes of a file that is not a raster, a computation.
/// `problems` is that of the VRT, which is in reach already. Throws BadInput.
void bring_sources_into_reach(GdalMessages& messages, RasterProblems& problems, GdalKind kind);

/// GDAL's name for the format of a file in reach, from its first bytes; empty if Talus does not read it as this kind.
[[nodiscard]] std::string driver_of(const std::string& name, GdalKind kind);

}  // namespace talus
