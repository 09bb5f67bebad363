#pragma once
// The coordinate system of survey data, and whether its units are metres on the ground.

#include <filesystem>
#include <optional>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"
#include "talus/import/las_file.hpp"

namespace talus {

struct SurveyCrs {
  std::string wkt;        // WKT 2; empty: not known
  std::string name;       // for messages, for example "EPSG:31287"
  bool is_local = false;  // metres that belong to no map; then there is no WKT
  [[nodiscard]] bool is_known() const { return !wkt.empty(); }
};

/// The coordinate system that the project sets.
struct ProjectCrs {
  SurveyCrs crs;          // of the terrain, and of files that have none; not known: that of the files
  bool is_local = false;  // metres that belong to no map, even if they look like degrees
};

/// The kind of a file, for the command in a hint that repairs it.
enum class SurveyKind { text, las, vector };

/// The part of such a text that names a file, for example "+nadgrids=../grid.gsb"; nullopt if there is none.
[[nodiscard]] std::optional<std::string> file_in_crs_words(const std::string& words);

/// A coordinate system from a text that PROJ understands: "EPSG:31287", "EPSG:31287+5778", well-known text. nullopt if
/// it is unknown, or if this program was built without GDAL.
[[nodiscard]] std::optional<SurveyCrs> crs_in_words(const std::string& words);

/// The coordinate system of a LAS file; not known if the file has none, with a warning unless the project sets one.
[[nodiscard]] SurveyCrs crs_of_las(const LasCrs& crs, const std::filesystem::path& file, const ProjectCrs& project_crs,
                                   Problems& warnings);

/// Whether two coordinate systems, both known, are the same on plan.
[[nodiscard]] bool have_same_plan(const SurveyCrs& a, const SurveyCrs& b);

/// Throws BadInput if the coordinate system of a terrain file is in degrees, not in metres, not in metres on the ground
/// at `centre`, or has heights in another unit; each with the command that repairs the file.
void check_survey_crs(const SurveyCrs& crs, const std::optional<Vec2>& centre, const std::filesystem::path& file,
                      SurveyKind kind, Problems& warnings);

}  // namespace talus
