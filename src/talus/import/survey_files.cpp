#include "talus/import/survey_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "talus/files/file_formats.hpp"
#include "talus/files/first_problems.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/gdal/zone_in_easting.hpp"
#include "talus/import/filler_values.hpp"
#include "talus/import/las_file.hpp"
#include "talus/import/mesh_text.hpp"
#include "talus/import/point_file.hpp"
#include "talus/import/survey_heights.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {
namespace {

struct PlanBox {
  Vec2 low = Vec2::all(std::numeric_limits<double>::infinity()), high = -low;
  void grow(const Vec3& p) {
    low = low.min(p.xy());
    high = high.max(p.xy());
  }
  [[nodiscard]] bool is_apart_from(const PlanBox& o) const {
    return !low.is_at_most(o.high) || !o.low.is_at_most(high);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}", low.x(), high.x(), low.y(), high.y());
  }
};

Problem problem(const std::filesystem::path& file, std::string what, std::string why, std::string hint = "") {
  return {.file = file.string(), .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)};
}

// The coordinate system of the terrain, to which all files are brought.
class CommonCrs {
 public:
  explicit CommonCrs(const ProjectCrs& project_crs) : project_crs_(project_crs), crs_(project_crs.crs) {}

  [[nodiscard]] const SurveyCrs& get() const { return crs_; }
  // The target for readers that can transform features.
  [[nodiscard]] const std::string& wanted() const { return crs_.wkt; }

  // Adds a file whose coordinates stay as they are.
  void add_unchanged(const SurveyCrs& of_file, const std::filesystem::path& file) {
    is_local_ = is_local_ || of_file.is_local;
    if (!of_file.is_known() && !of_file.is_local) return;
    if (of_file.is_known()) refuse_local(of_file, file);
    if (crs_.is_known() && (of_file.is_local || !have_same_plan(crs_, of_file))) {
      throw BadInput(problem(file, fmt::format("is in {}", of_file.name), fmt::format("crs is {}", crs_.name),
                             "Remove crs, or transform the file to it"));
    }
    if (of_file.is_known()) use(of_file);
  }

  // Adds a vector file, whose features were transformed to the target.
  void add_transformed(const VectorLayer& layer, const std::filesystem::path& file) {
    const SurveyCrs of_file{.wkt = layer.crs_wkt, .name = layer.crs_name};
    is_local_ = is_local_ || layer.crs_is_local;
    if (!of_file.is_known()) return;
    refuse_local(of_file, file);
    if (!crs_.is_known()) use(of_file);
  }

  /// Whether the project or a file says that the coordinates are metres that belong to no map.
  [[nodiscard]] bool is_local() const { return project_crs_.is_local || is_local_; }

 private:
  void refuse_local(const SurveyCrs& of_file, const std::filesystem::path& file) const {
    if (!is_local()) return;
    throw BadInput(problem(file, fmt::format("is in {}", of_file.name),
                           project_crs_.is_local ? "crs is \"local\"" : "the points have a local coordinate system",
                           project_crs_.is_local ? "Remove crs" : "Give both the same"));
  }
  void use(const SurveyCrs& crs) {
    if (!project_crs_.crs.is_known()) crs_ = crs;
  }

  const ProjectCrs& project_crs_;
  SurveyCrs crs_;
  bool is_local_ = false;
};

// `points_have_heights`: features without heights can be put on points that have them.
VectorLayer read_with_heights(const std::filesystem::path& path, VectorRequest request, const std::string& attribute,
                              bool others_have_heights, bool points_have_heights, CommonCrs& crs, Problems& warnings) {
  if (names_feet(attribute)) {
    throw BadInput(problem(path, fmt::format("attribute {} is in feet", in_quotes(attribute)),
                           "Talus needs heights in metres",
                           "Convert it to metres: a foot is 0.3048 m, a US survey foot 1200/3937 m"));
  }
  FeatureHeights heights(path, attribute, points_have_heights);
  request.attributes = heights.attributes();
  request.heights_are_used = attribute.empty();
  request.terrain_crs_wkt = crs.wanted();
  VectorLayer layer = read_vector_file(path, request, warnings);
  crs.add_transformed(layer, path);
  for (VectorFeature& feature : layer.features) heights.assign(feature);
  heights.finish(others_have_heights, request.layer_key, warnings);
  return layer;
}

// ---- the files of a survey ----

class SurveyReader {
 public:
  SurveyReader(const SurveySources& sources, Problems& warnings)
      : sources_(sources), warnings_(warnings), crs_(sources.project_crs) {}

  SurveyFiles read() {
    if (!sources_.points.empty()) read_points();
    if (!sources_.lines.empty()) read_lines();
    if (!sources_.boundary.empty()) read_boundary();
    check();
    files_.crs_wkt = crs_.get().wkt;
    return std::move(files_);
  }

 private:
  void report(const std::filesystem::path& file, const std::string& what) {
    files_.report += fmt::format("{}{}: {}", files_.report.empty() ? "" : "\n", file.string(), what);
  }

  void read_points() {
    const std::filesystem::path& file = sources_.points;
    if (is_of_kind(file, FileKind::las)) {
      kind_ = SurveyKind::las;
      read_las();
    } else if (is_of_kind(file, FileKind::point_text)) {
      kind_ = SurveyKind::text;
      files_.survey.points = read_point_file(file);
      report(file, fmt::format("{} points", files_.survey.points.size()));
    } else {
      kind_ = SurveyKind::vector;
      VectorRequest request;
      request.layer = sources_.points_layer;
      request.layer_key = "points_layer";
      request.kinds = {ShapeKind::point};
      const VectorLayer layer = read_with_heights(file, request, sources_.elevation_attribute, !sources_.lines.empty(),
                                                  false, crs_, warnings_);
      for (const VectorFeature& feature : layer.features) {
        for (const VectorShape& part : feature.parts) files_.survey.points.push_back(part.lists.front().front());
      }
      report(file, fmt::format("{} points of layer \"{}\"", files_.survey.points.size(), layer.name));
    }
    for (const Vec3& p : files_.survey.points) points_box_.grow(p);
    for (const DoubtfulHeight& doubt : doubtful_heights(files_.survey.points)) {
      if (doubt.height == 0 && kind_ == SurveyKind::vector) continue;  // reported with the features
      const Vec3& first = files_.survey.points[doubt.first];
      Problem warning = problem(
          file,
          fmt::format("{} at the height {:.10g}",
                      doubt.count == 1 ? "1 point lies" : fmt::format("{} points lie", doubt.count), doubt.height),
          fmt::format("the others lie from {:.10g} to {:.10g} m; the first is at ({:.10g}, {:.10g})", doubt.low,
                      doubt.high, first.x(), first.y()),
          "If it stands for a missing height, remove them");
      warning.severity = Severity::warning;
      warnings_.add(std::move(warning));
    }
  }

  void read_las() {
    LasFile las = read_las_file(sources_.points, sources_.point_classes);
    crs_.add_unchanged(crs_of_las(las.crs, sources_.points, sources_.project_crs, warnings_), sources_.points);
    std::string classes;
    for (const auto& [las_class, count] : las.of_class) {
      classes += fmt::format("{}{} of class {}", classes.empty() ? "" : ", ", count, las_class);
    }
    report(sources_.points,
           fmt::format("{} of {} points are used; it has {}{}", las.points.size(), las.declared, classes,
                       las.withheld > 0 ? fmt::format(" and {} withheld", las.withheld) : ""));
    const auto ground = las.of_class.find(2);
    if (sources_.point_classes.empty() && ground != las.of_class.end() && ground->second < las.points.size()) {
      Problem warning =
          problem(sources_.points, "has points of other classes than ground",
                  fmt::format("{} of the {} points used are classified as ground", ground->second, las.points.size()),
                  "To use the ground only, write point_classes = [2]");
      warning.severity = Severity::warning;
      warnings_.add(std::move(warning));
    }
    files_.survey.points = std::move(las.points);
  }

  void read_lines() {
    const std::filesystem::path& file = sources_.lines;
    const bool points_have_no_crs = !sources_.points.empty() && !crs_.get().is_known();
    VectorRequest request;
    request.layer = sources_.lines_layer;
    request.layer_key = "lines_layer";
    request.kinds = {ShapeKind::line, ShapeKind::polygon};
    VectorLayer layer = read_with_heights(file, request, sources_.elevation_attribute, !sources_.points.empty(),
                                          !sources_.points.empty(), crs_, warnings_);
    if (sources_.points.empty()) kind_ = SurveyKind::vector;
    if (points_have_no_crs && crs_.get().is_known()) {
      Problem warning =
          problem(sources_.points, "has no coordinate system",
                  fmt::format("{}, that of {}, is assumed", crs_.get().name, file.string()), "Set crs = \"...\" if so");
      warning.severity = Severity::warning;
      warnings_.add(std::move(warning));
    }
    std::size_t vertices = 0;
    for (VectorFeature& feature : layer.features) {
      for (VectorShape& part : feature.parts) {
        for (auto& list : part.lists) {
          if (list.empty()) continue;
          if (part.kind == ShapeKind::polygon) list.push_back(list.front());
          for (const Vec3& p : list) lines_box_.grow(p);
          vertices += list.size();
          const bool is_soft = !feature.has_z && sources_.elevation_attribute.empty();
          if (is_soft) {
            files_.soft_lines.push_back({fmt::format("feature {}", feature.id), std::move(list)});
          } else {
            files_.survey.lines.push_back(std::move(list));
          }
        }
      }
    }
    const std::size_t soft = files_.soft_lines.size();
    report(file,
           fmt::format("{} lines of {} vertices, of layer \"{}\"{}", files_.survey.lines.size() + soft, vertices,
                       layer.name, soft == 0 ? "" : fmt::format("; {} without heights, put on the points", soft)));
    if (sources_.points.empty() || !points_box_.is_apart_from(lines_box_)) return;
    throw BadInput(problem(
        file, "does not overlap the points",
        fmt::format("it covers {}, {} covers {}", lines_box_.text(), sources_.points.string(), points_box_.text()),
        "Are both in the same coordinate system?"));
  }

  void read_boundary() {
    const std::filesystem::path& file = sources_.boundary;
    VectorRequest request;
    request.layer = sources_.boundary_layer;
    request.layer_key = "boundary_layer";
    request.kinds = {ShapeKind::polygon};
    request.terrain_crs_wkt = crs_.wanted();
    const VectorLayer layer = read_vector_file(file, request, warnings_);
    crs_.add_transformed(layer, file);
    PlanBox box;
    for (const VectorFeature& feature : layer.features) {
      for (const VectorShape& part : feature.parts) {
        files_.boundary.emplace_back(part.lists);
        for (const Vec3& p : part.lists.front()) box.grow(p);
      }
    }
    const PlanBox survey = survey_box();
    if (survey.is_apart_from(box)) {
      throw BadInput(problem(file, "does not overlap the survey",
                             fmt::format("it covers {}, the survey covers {}", box.text(), survey.text()),
                             "Are both in the same coordinate system?"));
    }
  }

  [[nodiscard]] PlanBox survey_box() const {
    PlanBox box = points_box_;
    box.low = box.low.min(lines_box_.low);
    box.high = box.high.max(lines_box_.high);
    return box;
  }

  void check() {
    const PlanBox box = survey_box();
    const std::filesystem::path& file = sources_.points.empty() ? sources_.lines : sources_.points;
    if (crs_.get().is_known()) {
      check_survey_crs(crs_.get(), 0.5 * (box.low + box.high), file, kind_, warnings_);
      return;
    }
    if (crs_.is_local()) return;
    // Metres within 180 by 90 are the local coordinates of a small slope, which is wider than 10 m; a survey in degrees
    // is narrower than 10 degrees.
    constexpr double widest_in_degrees = 10;
    const bool may_be_degrees = box.low.x() >= -180 && box.high.x() <= 180 && box.low.y() >= -90 &&
                                box.high.y() <= 90 && (box.high - box.low).largest() < widest_in_degrees;
    if (may_be_degrees) {
      throw BadInput(problem(file, "seems to be in degrees",
                             fmt::format("it covers {}, and has no coordinate system", box.text()),
                             "Project it to metres; or, if it is in metres, set crs = \"local\""));
    }
    Problem warning = problem(file, "has no coordinate system", "its coordinates are assumed to be in metres",
                              "Set crs = \"EPSG:...\", or crs = \"local\"" + hint_for_zone(box));
    warning.severity = Severity::warning;
    warnings_.add(std::move(warning));
  }

  // Eastings with the number of a zone in front are those of Germany's Gauss-Krueger zones, and of others far to the
  // east; national grids without zones have some as well, but not there.
  [[nodiscard]] static std::string hint_for_zone(const PlanBox& box) {
    const Vec2 centre = 0.5 * (box.low + box.high);
    const auto zone = zone_in_easting(centre.x());
    constexpr double southernmost = 4.5e6, northernmost = 9.5e6;
    if (!zone || !((*zone >= 2 && *zone <= 5) || *zone >= 28) || centre.y() < southernmost || centre.y() > northernmost)
      return "";
    return fmt::format(". Its eastings seem to begin with the number of a zone, {}: {}", *zone, way_out_of_zone(*zone));
  }

  const SurveySources& sources_;
  Problems& warnings_;
  CommonCrs crs_;
  SurveyFiles files_;
  SurveyKind kind_ = SurveyKind::vector;
  PlanBox points_box_, lines_box_;
};

}  // namespace

SurveyFiles read_survey(const SurveySources& sources, Problems& warnings) {
  return SurveyReader(sources, warnings).read();
}

PolygonFile read_polygon_file(const std::filesystem::path& path, const std::string& layer_name,
                              const ProjectCrs& project_crs, double tolerance_m, Problems& warnings) {
  CommonCrs crs(project_crs);
  VectorRequest request;
  request.layer = layer_name;
  request.layer_key = "polygons_layer";
  request.kinds = {ShapeKind::line, ShapeKind::polygon};
  request.polygons_are_in_space = true;
  VectorLayer layer = read_with_heights(path, request, "", false, false, crs, warnings);
  PolygonFile file;
  FirstProblems problems(path.string(), "features");
  PlanBox box;
  for (VectorFeature& feature : layer.features) {
    for (std::size_t k = 0; k < feature.parts.size(); ++k) {
      VectorShape& part = feature.parts[k];
      std::string name = fmt::format("feature {}", feature.id);
      if (feature.parts.size() > 1) name += fmt::format(", part {},", k + 1);
      if (part.kind == ShapeKind::line) {
        auto& line = part.lists.front();
        const double apart = line.empty() ? 0 : (line.front() - line.back()).norm();
        if (apart > tolerance_m) {
          problems.add(0, name + " is not closed", fmt::format("its ends are {:.4g} m apart", apart),
                       "Repeat its first vertex at its end");
          continue;
        }
        if (!line.empty()) line.pop_back();
      }
      for (const auto& ring : part.lists) {
        for (const Vec3& p : ring) box.grow(p);
      }
      file.polygons.push_back({name, std::move(part.lists)});
    }
  }
  problems.throw_if_any();
  if (crs.get().is_known()) check_survey_crs(crs.get(), 0.5 * (box.low + box.high), path, SurveyKind::vector, warnings);
  file.crs_wkt = crs.get().wkt;
  return file;
}

}  // namespace talus
