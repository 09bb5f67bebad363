#pragma once
// The tables of the project file, each declared in the file of its name.

#include "talus/project/settings.hpp"

namespace talus::project::declared {

Table head_table();
Table analysis_table();
Table sampling_table();
Table terrain_table();
Table material_table();
Table ground_table();
Table area_table();
Table forest_table();
Table shape_table();
Table seeder_table();
Table barrier_table();
Table collector_table();
Table kit_table();
Table design_table();
Table output_table();
Table report_table();
Table layer_table();
Table distribution_table();

}  // namespace talus::project::declared
