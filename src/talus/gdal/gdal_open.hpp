#pragma once
// The only place where files are opened with GDAL. Only for files that are built with GDAL.

#include <filesystem>
#include <string>
#include <vector>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/gdal_start.hpp"

namespace talus {

/// Opens a file, or a member of an archive on disk (/vsizip/FILE/MEMBER, /vsigzip/FILE), for reading, as one of the
/// formats that Talus reads; its contents decide which. Adds it, the files that belong to it and the sources of a VRT
/// to the reach of `messages`; nothing else is opened, whatever the file refers to. Throws BadInput.
[[nodiscard]] GDALDatasetUniquePtr open_with_gdal(GdalKind kind, GdalMessages& messages, RasterProblems& problems,
                                                  const char* const* options = nullptr);

/// Throws BadInput if queries of the file were ended by their limit, which looks like the end of its data.
void expect_end_of_queries(GdalMessages& messages, RasterProblems& problems);

/// GDAL's name for the format of a file, which is added to the reach of `messages`; empty if Talus does not read it as
/// this kind. Throws BadInput if there is no such file.
[[nodiscard]] std::string format_of_file(GdalKind kind, GdalMessages& messages, RasterProblems& problems);

/// The name of a file in a form that GDAL cannot mistake: it might read the part before a colon as a format.
[[nodiscard]] std::string name_for_gdal(const std::filesystem::path& file);

/// The names of drivers as GDAL expects them: a null-terminated list.
[[nodiscard]] std::vector<const char*> drivers_that_read(GdalKind kind);

}  // namespace talus
