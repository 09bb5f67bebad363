#pragma once
// Paths for ParaView and other programs that read VTK files.

#include <filesystem>

namespace talus {

inline constexpr const char* vtk_paths_name = "paths.vtp";

/// Largest distance between the lines and the arcs of flights [m].
inline constexpr double vtk_tolerance_m = 0.05;

/// Makes FOLDER/paths.vtp from FOLDER/paths.csv: VTK's XML PolyData with raw appended data, one line for each rock
/// through the points of path_arcs.hpp. Each point has time_s, velocity_m_s, ke_total_J (translational and rotational)
/// and state (its number in PathState); each line has its rock. Reads the table twice, first to count, and keeps one
/// path in memory. The file appears when it is complete. Throws BadInput if the table is damaged or the file cannot be
/// written.
///
/// Source of the format: "VTK File Formats" in the VTK User's Guide, section "XML file formats", PolyData.
void write_vtk_paths(const std::filesystem::path& folder);

}  // namespace talus
