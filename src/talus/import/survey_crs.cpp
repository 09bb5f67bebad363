#include "talus/import/survey_crs.hpp"

#include <fmt/format.h>

#include <cmath>

#ifdef TALUS_HAS_GDAL

#include "talus/gdal/raster_crs.hpp"
#include "talus/import/vector_shapes.hpp"

namespace talus {
namespace {

// The name of a new file next to this one, in a form that a shell reads.
std::string new_file(const std::filesystem::path& file, const std::string& ending) {
  std::filesystem::path made = file;
  made.replace_filename(file.stem().string() + ending);
  return shell_word(made.string());
}

// The length in metres of an EPSG unit of measure; nullopt if not known.
std::optional<double> metres_of_unit(const std::optional<int>& epsg) {
  if (!epsg) return std::nullopt;
  return *epsg == 9001 ? 1 : *epsg == 9002 ? 0.3048 : *epsg == 9003 ? 1200.0 / 3937 : std::optional<double>();
}

/// `crs`: that of the file, null if it is not known.
CrsCommands commands_for(const std::filesystem::path& file, SurveyKind kind, const OGRSpatialReference* crs = nullptr) {
  const std::string old = shell_word(file.string());
  const std::string keeping = crs ? option_to_keep_heights(*crs) : "";  // " -s_srs EPSG:XXXX"
  switch (kind) {
    case SurveyKind::text:
      return {[=](const std::string& target) {
                return fmt::format("gdaltransform -s_srs EPSG:XXXX -t_srs {} < {} > {}, on lines of x y z", target, old,
                                   new_file(file, "_metres.xyz"));
              },
              "crs = \"EPSG:XXXX\" in [terrain]"};
    case SurveyKind::las:
      return {[=](const std::string& target) {
                constexpr std::size_t option = 8;  // " -s_srs "
                return fmt::format("pdal translate {} {} reprojection{} --filters.reprojection.out_srs={}", old,
                                   new_file(file, "_metres.las"),
                                   keeping.empty() ? "" : " --filters.reprojection.in_srs=" + keeping.substr(option),
                                   target);
              },
              fmt::format("pdal translate {} {} --writers.las.a_srs=EPSG:XXXX", old, new_file(file, "_placed.las"))};
    case SurveyKind::vector:
      break;
  }
  return {[=](const std::string& target) {
            return ogr2ogr((keeping.empty() ? "" : keeping.substr(1) + " ") + "-t_srs " + target, file, "_metres.gpkg");
          },
          ogr2ogr("-a_srs EPSG:XXXX", file, "_placed.gpkg")};
}

OGRSpatialReference read(const SurveyCrs& crs) {
  OGRSpatialReference out;
  out.importFromWkt(crs.wkt.c_str());
  return out;
}

SurveyCrs known_crs(const OGRSpatialReference& crs) {
  if (is_local(crs) && std::abs(crs.GetLinearUnits() - 1) <= 1e-9)
    return {.wkt = {}, .name = name_of(crs), .is_local = true};
  return {.wkt = wkt_of(crs), .name = name_of(crs)};
}

OGRSpatialReference plan_of(const SurveyCrs& crs) {
  OGRSpatialReference out = read(crs);
  if (out.IsCompound()) out.StripVertical();
  out.DemoteTo2D(nullptr);
  return out;
}

}  // namespace

std::optional<std::string> file_in_crs_words(const std::string& words) { return file_named_in(words); }

std::optional<SurveyCrs> crs_in_words(const std::string& words) {
  GdalMessages messages;
  if (auto fault = fault_of_proj(messages)) throw BadInput(std::move(*fault));
  OGRSpatialReference crs;
  if (crs.SetFromUserInput(words.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE) {
    return std::nullopt;
  }
  return known_crs(crs);
}

SurveyCrs crs_of_las(const LasCrs& las, const std::filesystem::path& file, const ProjectCrs& project_crs,
                     Problems& warnings) {
  GdalMessages messages;
  if (auto fault = fault_of_proj(messages)) throw BadInput(std::move(*fault));
  OGRSpatialReference crs;
  bool is_known = !las.wkt.empty() && crs.importFromWkt(las.wkt.c_str()) == OGRERR_NONE;
  const std::optional<int> epsg = las.projected_epsg && !las.is_geographic ? las.projected_epsg : las.geographic_epsg;
  if (!is_known && epsg) {
    const std::string vertical = las.vertical_epsg ? fmt::format("+{}", *las.vertical_epsg) : "";
    is_known = crs.SetFromUserInput(fmt::format("EPSG:{}{}", *epsg, vertical).c_str()) == OGRERR_NONE ||
               crs.SetFromUserInput(fmt::format("EPSG:{}", *epsg).c_str()) == OGRERR_NONE;
  }
  RasterProblems problems(file);
  const CrsCommands commands = commands_for(file, SurveyKind::las);
  if (!is_known && las.is_geographic) {
    problems.stop("is in degrees", "its coordinate system is geographic; Talus needs metres on plan",
                  "Project it: " + commands.project("EPSG:XXXX"));
  }
  // The units may have keys of their own, with or without a coordinate system.
  for (const auto& [unit, what] : {std::pair{las.plan_unit_epsg, "is not in metres on plan"},
                                   std::pair{las.vertical_unit_epsg, "has heights that are not in metres"}}) {
    const auto metres = metres_of_unit(unit);
    if (!unit || (metres && *metres == 1)) continue;
    problems.refuse(what,
                    metres ? fmt::format("its unit is EPSG:{}, {:.10g} m", *unit, *metres)
                           : fmt::format("its unit is EPSG:{}", *unit),
                    "Transform it to one in metres: " + commands.project("EPSG:XXXX"));
  }
  problems.throw_if_any();
  if (is_known && is_local(crs)) {
    check_terrain_crs(crs, std::nullopt, problems, commands);
    problems.throw_if_any();
  }
  if (is_known) return known_crs(crs);
  if (project_crs.crs.is_known() || project_crs.is_local) return {};
  warnings.add(Problem{.severity = Severity::warning,
                       .file = file.string(),
                       .where = {},
                       .what = "has no coordinate system that Talus understands",
                       .why = "its coordinates are assumed to be in metres",
                       .hint = "Assign one: " + commands.name});
  return {};
}

bool have_same_plan(const SurveyCrs& a, const SurveyCrs& b) {
  const OGRSpatialReference first = plan_of(a), second = plan_of(b);
  static const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
  return first.IsSame(&second, options);
}

void check_survey_crs(const SurveyCrs& crs, const std::optional<Vec2>& centre, const std::filesystem::path& file,
                      SurveyKind kind, Problems& warnings) {
  const GdalMessages messages;
  RasterProblems problems(file);
  const OGRSpatialReference reference = read(crs);
  const CrsCommands commands = commands_for(file, kind, &reference);
  if (const auto fault = reference.IsVertical() ? fault_of_heights(reference) : std::nullopt) {
    problems.refuse(fault->what, fault->why,
                    "Transform it to one with heights in metres: " + commands.project("EPSG:XXXX+XXXX"));
  }
  check_terrain_crs(reference, centre, problems, commands);
  problems.throw_if_any();
  warnings.append(problems.warnings());
}

}  // namespace talus

#else

namespace talus {

std::optional<std::string> file_in_crs_words(const std::string&) { return std::nullopt; }

std::optional<SurveyCrs> crs_in_words(const std::string&) { return std::nullopt; }

SurveyCrs crs_of_las(const LasCrs& las, const std::filesystem::path& file, const ProjectCrs& project_crs,
                     Problems& warnings) {
  if (las.is_geographic) {
    throw BadInput(Problem{.file = file.string(),
                           .where = {},
                           .what = "is in degrees",
                           .why = "its coordinate system is geographic; Talus needs metres on plan",
                           .hint = {}});
  }
  if (project_crs.crs.is_known() || project_crs.is_local) return {};
  warnings.add(Problem{.severity = Severity::warning,
                       .file = file.string(),
                       .where = {},
                       .what = "may have a coordinate system",
                       .why = "this build of Talus cannot read it without GDAL",
                       .hint = "Its coordinates are assumed to be in metres"});
  return {};
}

bool have_same_plan(const SurveyCrs& a, const SurveyCrs& b) { return a.wkt == b.wkt; }

void check_survey_crs(const SurveyCrs&, const std::optional<Vec2>&, const std::filesystem::path&, SurveyKind,
                      Problems&) {}

}  // namespace talus

#endif
