#pragma once
// The cells from which the rocks of a polygon or raster seeder start.

#include <functional>
#include <optional>
#include <string>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// What choosing needs beside the seeder.
struct CellQuestion {
  const Project& project;
  const Model& model;  // its surface, frame and coordinate system
  std::function<SourceId(const std::string& name)> source_of;
};

/// Cells that are within the polygons (all, where the seeder has none), not too steep and not too gentle, and wanted by
/// the mask: each at its middle. A cell within several polygons has the source of the last. Nothing where there is none
/// or a file is refused, with the reason in `problems`; doubts go to `warnings`. `report` becomes what was found, in
/// one line for the user.
[[nodiscard]] std::optional<ReleaseCells> choose_cells(const Seeder& seeder, const CellQuestion& question,
                                                       Problems& problems, Problems& warnings, std::string& report);

}  // namespace talus::project
