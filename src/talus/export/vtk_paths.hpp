#pragma once
// Paths for ParaView and other programs that read VTK's files.

#include <filesystem>

namespace talus {

inline constexpr const char* vtk_paths_name = "paths.vtp";

/// How far the lines may depart from the arcs of flights [m].
inline constexpr double vtk_tolerance_m = 0.05;

/// Makes FOLDER/paths.vtp of FOLDER/paths.csv: VTK's XML PolyData with raw appended data, one line a rock through the
/// points of path_arcs.hpp. Of each point time_s, velocity_m_s, ke_total_J (translational and rotational) and state (by
/// its number in PathState); of each line its rock. Reads the table twice, once to count, and keeps one path in memory.
/// The file appears when it is whole. Throws BadInput where the table is not what it should be, and where the file
/// cannot be written.
///
/// Source of the format: "VTK File Formats" of the VTK User's Guide, section "XML file formats", PolyData.
void write_vtk_paths(const std::filesystem::path& folder);

}  // namespace talus
