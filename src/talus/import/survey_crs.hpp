#pragma once
// The coordinate system of survey data, and whether their numbers are metres on the ground.

#include <filesystem>
#include <optional>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"
#include "talus/import/las_file.hpp"

namespace talus {

struct SurveyCrs {
  std::string wkt;   // WKT 2; empty: not known
  std::string name;  // for people, for example "EPSG:31287"
  [[nodiscard]] bool is_known() const { return !wkt.empty(); }
};

/// What the project says of coordinates.
struct ProjectCrs {
  SurveyCrs crs;          // of files that name none, and of the terrain; not known: that of the files
  bool is_local = false;  // metres of no map, even where they look like degrees
};

/// What a command that mends such a file looks like.
enum class SurveyKind { text, las, vector };

/// A coordinate system in words that PROJ knows: "EPSG:31287", "EPSG:31287+5778", well-known text. Nothing where it
/// knows none of that name, or where this program was built without GDAL.
[[nodiscard]] std::optional<SurveyCrs> crs_in_words(const std::string& words);

/// That of a LAS file; not known where the file does not say, with a warning unless the project does.
[[nodiscard]] SurveyCrs crs_of_las(const LasCrs& crs, const std::filesystem::path& file, const ProjectCrs& said,
                                   Problems& warnings);

/// Whether two coordinate systems have the same plan; both must be known.
[[nodiscard]] bool have_same_plan(const SurveyCrs& a, const SurveyCrs& b);

/// Throws BadInput where the coordinate system of a file that makes the terrain is in degrees, not in metres, not in
/// metres of the ground at `centre`, or has heights in another unit; each with the command that mends it.
void check_survey_crs(const SurveyCrs& crs, const std::optional<Vec2>& centre, const std::filesystem::path& file,
                      SurveyKind kind, Problems& warnings);

}  // namespace talus
