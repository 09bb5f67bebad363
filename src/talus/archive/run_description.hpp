#pragma once
// Everything that summary.json, the maps and the report need besides the sums over rocks and the tables. With these
// three they can be written without the project's files.

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/archive/table_rocks.hpp"
#include "talus/core/vec.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/results/design_plan.hpp"

namespace talus {

/// The maps of a run; for a section, one row of cells along it.
struct MapPlan {
  Vec2 origin, cell;  // of the grid, as in results/map_grid.hpp
  bool by_source = false;
  std::uint64_t ensembles = 0;  // with maps of their own, for the selection's bands
  MapSelection selection{};
};

struct RunDescription {
  std::string name;
  std::string fingerprint;           // of all inputs of the results
  std::uint64_t paths_revision = 0;  // campaign/paths_revision.hpp; 0: of a program without
  /// Hash of some trajectories: machines or builds of the program with the same hash compute the same bits.
  std::string sample;
  std::uint64_t rocks = 0;           // of the whole campaign
  std::size_t barriers = 0;          // number of barriers and collectors
  nlohmann::ordered_json project;    // complete, with defaults
  nlohmann::ordered_json model;      // model_json()
  ToldWarnings warnings;             // known before the run
  std::string crs_wkt;               // of the user coordinates; empty: unknown
  std::vector<std::string> sources;  // their names
  std::optional<MapPlan> maps;       // nullopt: no maps
  std::optional<DesignPlan> design;  // nullopt: no design of barriers
  bool wants_maps = false;           // on 3D terrain
  bool wants_envelopes = false;      // along a section
  bool wants_geopackage = false;     // on 3D terrain only
  bool wants_report = true;
  ReportInputs inputs;  // of the first process only
  // The store of trajectories, at most: its bytes, about, and its rocks; nullopt: no store.
  std::optional<std::uint64_t> store_bytes;
  std::uint64_t store_rocks = std::numeric_limits<std::uint64_t>::max();
};

/// The origin of the model's local frame in user coordinates [m].
[[nodiscard]] Vec3 origin_of(const RunDescription& description);

/// The rocks in the tables, from `output` in the project; all without it.
[[nodiscard]] TableRocks rocks_in_tables(const RunDescription& description);

/// The description as JSON.
[[nodiscard]] std::string json_text(const RunDescription& description);
/// Reads the text of json_text(). Throws BadBytes on anything else.
[[nodiscard]] RunDescription description_from(std::string_view json_text);

}  // namespace talus
