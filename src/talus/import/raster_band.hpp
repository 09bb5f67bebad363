#pragma once
// The cells of a raster of elevations. Only for files that are built with GDAL.

#include <gdal_priv.h>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/import/raster_checks.hpp"
#include "talus/import/raster_file.hpp"

namespace talus {

/// Reads a band into `out`: turns it north up, applies scale and offset, and sets cells without data to NaN. Throws
/// BadInput if it cannot be read, has impossible elevations or no surface; warns of zeros that seem to be no data.
void read_band(GDALRasterBand& band, const RasterPlacing& placing, GdalMessages& messages, RasterProblems& problems,
               RasterFile& out);

}  // namespace talus
