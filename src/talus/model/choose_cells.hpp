#pragma once
// The cells from which the rocks of a polygon or raster seeder start.

#include <functional>
#include <optional>
#include <string>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The context of a choice of cells.
struct CellContext {
  const Project& project;
  const Model& model;  // its surface, frame and coordinate system
  std::function<SourceId(const std::string& name)> source_of;
};

/// The cells whose centres are within the polygons (if any) and selected by the mask (if any), with a slope within the
/// limits. A cell within several polygons has the source of the last one. nullopt if there is none or a file is
/// refused, with the reason in `problems`; doubts are added to `warnings`. `report` is set to a one-line summary for
/// the user.
[[nodiscard]] std::optional<ReleaseCells> choose_cells(const Seeder& seeder, const InCells& cells,
                                                       const CellContext& context, Problems& problems,
                                                       Problems& warnings, std::string& report);

}  // namespace talus::project
