#pragma once
// Which files PROJ may open: ordinary ones in its own folders. Only for files that are built with GDAL.

namespace talus {

/// Coordinate systems may name grids, initialisation files and models by any path. From now on PROJ, as GDAL uses it,
/// reads only ordinary files in the folders where it keeps its own data, and writes none. To be called before GDAL's
/// first use of PROJ.
void guard_proj_files();

}  // namespace talus
