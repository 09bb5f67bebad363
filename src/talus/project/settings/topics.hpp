#pragma once
// Sections of the documents that the help of settings links to.

#include "talus/project/settings.hpp"

namespace talus::project::declared::topics {

constexpr Topic laws{"laws.md", "The laws"};
constexpr Topic which_model{"which-model.md", "Which model?"};
constexpr Topic equations{"laws.md", "The equations of the lumped mass"};
constexpr Topic points{"laws.md", "Points worth knowing"};
constexpr Topic law_sets{"laws.md", "Two sets of laws"};
constexpr Topic rough_ground{"laws.md", "Rough ground"};
constexpr Topic forest{"laws.md", "Forest"};
constexpr Topic soft_ground{"laws.md", "Soft ground"};
constexpr Topic terrain{"terrain.md", "Terrain"};
constexpr Topic rasters{"terrain.md", "Rasters"};
constexpr Topic section_files{"terrain.md", "A section from a file"};
constexpr Topic survey{"terrain.md", "A survey as terrain"};
constexpr Topic library{"materials.md", "The library of materials"};
constexpr Topic ground{"gis.md", "Ground from polygons"};
constexpr Topic areas{"gis.md", "Areas drawn on plan"};
constexpr Topic lines{"gis.md", "Lines"};
constexpr Topic vector_files{"gis.md", "Vector files"};
constexpr Topic cells{"gis.md", "Seeders on cells"};
constexpr Topic release_table{"gis.md", "A table of releases"};
constexpr Topic layers{"gis.md", "Reference layers"};
constexpr Topic shapes{"shapes.md", "Shapes of rocks"};
constexpr Topic seeders{"project-file.md", "`[[seeder]]`"};
constexpr Topic sampling{"project-file.md", "`[sampling]`"};
constexpr Topic output{"project-file.md", "`[output]`"};
constexpr Topic paths{"outputs.md", "paths.csv"};
constexpr Topic impacts{"outputs.md", "impacts.csv"};
constexpr Topic trajectories{"outputs.md", "trajectories.bin"};
constexpr Topic runout{"outputs.md", "Runout"};
constexpr Topic geopackage{"outputs.md", "results.gpkg"};
constexpr Topic vtk{"outputs.md", "paths.vtp"};
constexpr Topic maps{"outputs.md", "maps/"};
constexpr Topic sheet{"sheet.md", "The title block"};
constexpr Topic design{"barrier-design.md", "What is counted"};
constexpr Topic design_check{"barrier-design.md", "The check"};
constexpr Topic factor_file{"barrier-design.md", "A set of factors of one's own"};
constexpr Topic design_table{"barrier-design.md", "design.csv"};
constexpr Topic confidence{"barrier-design.md", "Confidence"};
constexpr Topic kits{"barrier-design.md", "Kits"};
constexpr Topic elongation{"barrier-design.md", "Elongation"};
constexpr Topic free_ends{"barrier-design.md", "Free ends"};
constexpr Topic pairs{"barrier-design.md", "Two lines"};
constexpr Topic ranking{"barrier-design.md", "Which line, height and energy"};

}  // namespace talus::project::declared::topics
