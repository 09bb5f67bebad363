#pragma once
// The one place where files are opened with GDAL. For files that are built with GDAL only.

#include <filesystem>
#include <string>
#include <vector>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/gdal_start.hpp"

namespace talus {

/// Opens a file, or a member of an archive on the disk (/vsizip/FILE/MEMBER, /vsigzip/FILE), to read from: as one of
/// the formats that Talus reads, chosen by what the file holds. From then on `messages` has it in reach, what belongs
/// to it, and what a VRT names beside it: nothing else is opened, whatever the file names. Throws BadInput.
[[nodiscard]] GDALDatasetUniquePtr open_with_gdal(GdalKind kind, GdalMessages& messages, RasterProblems& problems,
                                                  const char* const* options = nullptr);

/// A name that GDAL takes for that of a file, and for nothing else: what stands before a colon may be a format to it.
[[nodiscard]] std::string name_for_gdal(const std::filesystem::path& file);

/// The names of drivers as GDAL wants them: a list that ends with a null.
[[nodiscard]] std::vector<const char*> drivers_that_read(GdalKind kind);

}  // namespace talus
