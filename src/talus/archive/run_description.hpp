#pragma once
// All that the results of a run depend on besides its sums over rocks and its tables: who has these three can write
// summary.json, the maps and the report without the project's files.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/table_rocks.hpp"
#include "talus/core/vec.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/results/design_plan.hpp"

namespace talus {

/// The maps that a run makes; of a section, in one row of cells along it.
struct MapPlan {
  Vec2 origin, cell;  // of the grid, as in results/map_grid.hpp
  bool by_source = false;
  MapSelection selection{};
};

struct RunDescription {
  std::string name;
  std::string fingerprint;  // of everything that the results follow from
  /// Of the paths of some rocks: two machines, or two builds of the program, that agree in it compute the same bits.
  std::string sample;
  std::uint64_t rocks = 0;            // of the whole campaign
  std::size_t barriers = 0;           // and collectors
  nlohmann::ordered_json project;     // echoed whole, defaults filled in
  nlohmann::ordered_json model;       // as model_json() has it
  std::vector<std::string> warnings;  // those known before the run
  std::string crs_wkt;                // of the user's coordinates; empty: not known
  std::vector<std::string> sources;   // their names
  std::optional<MapPlan> maps;        // that are gathered; nothing: none
  std::optional<DesignPlan> design;   // of barriers; nothing: none
  bool wants_maps = false;            // of 3D terrain
  bool wants_envelopes = false;       // of a section
  bool wants_geopackage = false;      // that can be made on 3D terrain only
  bool wants_report = true;
};

/// Of the model's local frame, in the user's coordinates [m].
[[nodiscard]] Vec3 origin_of(const RunDescription& description);

/// Those that the tables hold one by one, as `output` in the project says; all where it does not.
[[nodiscard]] TableRocks rocks_in_tables(const RunDescription& description);

/// As JSON.
[[nodiscard]] std::string json_text(const RunDescription& description);
/// Throws BadBytes where the text is not what json_text() gave.
[[nodiscard]] RunDescription description_from(std::string_view json_text);

}  // namespace talus
