#include "talus/calibration/observed_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/observation_table.hpp"
#include "talus/files/data_table.hpp"
#include "talus/import/vector_file.hpp"

namespace talus::calibration {

namespace {

constexpr std::size_t most_places_reported = 5;
constexpr double far_off_the_ground = 1;  // [m]

const std::vector<ObservedColumn> place_columns{{"x_m", {"x"}},          {"y_m", {"y"}},        {"z_m", {"z"}},
                                                {"release", {"seeder"}}, {"rock", {"rock_id"}}, {"mass_kg", {}}};
enum PlaceColumn { place_x, place_y, place_z, place_release, place_rock, place_mass };
constexpr int first_place_attribute = place_release;  // of maps, whose points have the coordinates

class PlaceReader {
 public:
  PlaceReader(const Study& study, const StudyObservations& from, const study::PreparedSite& site, Problems& warnings)
      : from_(from),
        site_(site),
        is_2d_(site.project().is_2d()),
        file_(study.file.parent_path() / from.file()),
        warnings_(warnings) {}

  std::vector<ObservedPlace> read() {
    std::vector<ObservedPlace> places = is_text_table(file_) ? from_table() : from_map();
    check_positions(places);
    check_masses(places);
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    return places;
  }

 private:
  std::vector<ObservedPlace> from_table() {
    const ObservationTable table(file_);
    table.check_columns(columns_that_count(), problems_, warnings_);
    const auto find = [&](PlaceColumn column) { return table.find(place_columns[column]); };
    const auto x = find(place_x), y = find(place_y), z = find(place_z), release = find(place_release),
               rock = find(place_rock), mass = find(place_mass);
    if (!x || (!y && !is_2d_)) {
      if (problems_.has_errors()) throw BadInput(std::move(problems_));
      throw BadInput(Problem{.file = table.file(),
                             .line = 1,
                             .what = fmt::format("there is no column {}", !x ? "x_m" : "y_m"),
                             .why = fmt::format("the columns are {}", fmt::join(table.columns(), ", ")),
                             .hint = table.is_in_degrees()
                                         ? "Degrees are read from points of a GeoPackage, Shapefile or GeoJSON"
                                         : "Name the columns of the coordinates x_m and y_m, in metres"});
    }
    if (is_2d_ && y) {
      warnings_.add({Severity::warning, table.file(), 1, "", "column y_m is not read", "a section has x alone",
                     "Check that x_m is along the section, as its vertices have it"});
    }
    if (!from_.marks.empty() && !rock) say_marks_are_alike(table);
    std::vector<ObservedPlace> places;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      ObservedPlace one;
      one.place = table.at(row);
      one.has_z = z && !table.text(row, *z).empty();
      one.position.x() = table.number(row, *x, problems_).value_or(0);
      if (!is_2d_) one.position.y() = table.number(row, *y, problems_).value_or(0);
      if (one.has_z) one.position.z() = table.number(row, *z, problems_).value_or(0);
      if (release) one.release = table.text(row, *release);
      if (rock) one.rock = table.text(row, *rock);
      if (mass && !table.text(row, *mass).empty()) one.mass = table.number(row, *mass, problems_);
      places.push_back(std::move(one));
    }
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    return places;
  }

  void say_marks_are_alike(const ObservationTable& table) const {
    if (from_.weight != 1) return;
    warnings_.add({Severity::warning, table.file(), 1, "", "there is no column rock",
                   "marks of one rock are not independent of each other",
                   "Name the rock of each mark in a column rock, or give the observations a weight below 1"});
  }

  std::vector<ObservedPlace> from_map() {
    if (is_2d_) {
      throw BadInput(Problem{.file = file_.string(),
                             .what = "points of a map cannot be compared with a section",
                             .why = "expected a CSV file with the column x_m"});
    }
    std::vector<std::string> chosen;
    const VectorRequest request{.layer = from_.layer,
                                .attributes = {},
                                .kinds = {ShapeKind::point},
                                .polygons_are_in_space = false,
                                .heights_are_used = false,
                                .terrain_crs_wkt = site_.model().crs_wkt,
                                .choose = [&](const std::vector<std::string>& names) {
                                  std::vector<ObservedColumn> columns = columns_that_count();
                                  columns.erase(columns.begin(), columns.begin() + first_place_attribute);
                                  check_column_names({.file = file_.string()}, names, columns, problems_, warnings_);
                                  return chosen = attributes_of(names);
                                }};
    std::vector<ObservedPlace> places;
    const VectorLayer layer = read_vector_file(file_, request, warnings_);
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    for (const VectorFeature& feature : layer.features) {
      for (const VectorShape& part : feature.parts) {
        ObservedPlace one;
        one.position = part.lists.front().front();
        one.has_z = feature.has_z;
        one.place = {.file = file_.string(), .where = fmt::format("feature {}", feature.id)};
        for (std::size_t k = 0; k < chosen.size(); ++k) {
          if (feature.values[k] && !feature.values[k]->empty()) take(chosen[k], *feature.values[k], one);
        }
        places.push_back(std::move(one));
      }
    }
    return places;
  }

  /// Those of a map's attributes that are read. (Shapefiles have names of ten letters at most: all fit.)
  static std::vector<std::string> attributes_of(const std::vector<std::string>& names) {
    std::vector<std::string> chosen;
    for (const std::string& name : names) {
      const auto is_named = [&](const ObservedColumn& column) { return column.is_named(name); };
      if (std::any_of(place_columns.begin() + first_place_attribute, place_columns.end(), is_named))
        chosen.push_back(name);
    }
    return chosen;
  }

  /// Of stops, the name of a rock is a note.
  [[nodiscard]] std::vector<ObservedColumn> columns_that_count() const {
    std::vector<ObservedColumn> columns = place_columns;
    if (from_.marks.empty()) columns.erase(columns.begin() + place_rock);
    return columns;
  }

  void take(const std::string& name, const std::string& text, ObservedPlace& one) {
    if (place_columns[place_release].is_named(name)) one.release = text;
    if (place_columns[place_rock].is_named(name)) one.rock = text;
    if (!place_columns[place_mass].is_named(name)) return;
    one.mass = number_in_cell(text, false);
    if (one.mass && std::isfinite(*one.mass)) return;
    Problem problem = one.place;
    problem.what = fmt::format("mass_kg is \"{}\"", text);
    problem.why = "expected a number";
    problems_.add(std::move(problem));
  }

  void check_positions(const std::vector<ObservedPlace>& places) {
    std::size_t off = 0, swapped = 0, high = 0;
    double most = 0;
    for (const ObservedPlace& one : places) {
      const auto ground = elevation_at(site_, one.position.xy());
      if (!ground) {
        if (!is_2d_ && elevation_at(site_, {one.position.y(), one.position.x()})) ++swapped;
        if (++off > most_places_reported) continue;
        Problem problem = one.place;
        problem.what = is_2d_
                           ? fmt::format("x = {:.10g} is off the terrain", one.position.x())
                           : fmt::format("({:.10g}, {:.10g}) is off the terrain", one.position.x(), one.position.y());
        problem.why = extent_of(site_);
        problems_.add(std::move(problem));
      } else if (one.has_z && std::abs(one.position.z() - *ground) > far_off_the_ground) {
        ++high;
        most = std::max(most, std::abs(one.position.z() - *ground));
      }
    }
    if (off > 0) {
      std::string hint = "Leave out what lies off the terrain, or extend the terrain";
      if (off == places.size()) {
        hint = is_2d_ ? "Give x along the section, as its vertices have it"
               : is_text_table(file_)
                   ? "Convert them to the terrain's coordinates, or give them as points in a GIS file, "
                     "which are converted"
                   : "Check the coordinate systems of the file and of the terrain";
      }
      if (swapped == off) hint = "x and y seem to be exchanged";
      problems_.add(
          {.file = file_.string(),
           .what = fmt::format("{} of {} observations {} off the terrain", off, places.size(), off == 1 ? "is" : "are"),
           .why = off == places.size() && swapped != off ? "they may be in another coordinate system" : "",
           .hint = std::move(hint)});
    }
    if (high > 0) {
      warnings_.add(
          {Severity::warning, file_.string(), 0, "",
           fmt::format("{} of {} observed {} {} more than {:g} m above or below the terrain", high, places.size(),
                       from_.marks.empty() ? "stops" : "marks", high == 1 ? "is" : "are", far_off_the_ground),
           fmt::format("up to {:.1f} m", most), "Compare their heights and coordinates with the terrain"});
    }
  }

  void check_masses(const std::vector<ObservedPlace>& places) {
    for (const ObservedPlace& one : places) {
      if (!one.mass || *one.mass > 0) continue;
      Problem problem = one.place;
      problem.what = fmt::format("mass_kg is {:g}", *one.mass);
      problem.why = "expected more than 0";
      problem.hint = "Leave it empty if it is not known";
      problems_.add(std::move(problem));
    }
  }

  const StudyObservations& from_;
  const study::PreparedSite& site_;
  bool is_2d_;
  std::filesystem::path file_;
  Problems& warnings_;
  Problems problems_;
};

}  // namespace

bool is_text_table(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".csv" || ending == ".txt" || ending == ".tsv";
}

std::optional<double> elevation_at(const study::PreparedSite& site, const Vec2& place) {
  const Vec3 local = site.model().frame.local_from_global({place.x(), place.y(), 0});
  const auto z =
      std::visit([&](const auto& surface) { return surface.elevation(local.x(), local.y()); }, *site.model().surface);
  if (!z) return std::nullopt;
  return *z + site.model().frame.origin.z();
}

std::string extent_of(const study::PreparedSite& site) {
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *site.model().surface);
  const Vec3 low = site.model().frame.global_from_local(box.low);
  const Vec3 high = site.model().frame.global_from_local(box.high);
  if (site.project().is_2d()) {
    return fmt::format("the section extends from x = {:.10g} to {:.10g}", low.x(), high.x());
  }
  return fmt::format("on plan the terrain lies within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}", low.x(),
                     high.x(), low.y(), high.y());
}

std::vector<ObservedPlace> read_places(const Study& study, const StudyObservations& from,
                                       const study::PreparedSite& site, Problems& warnings) {
  return PlaceReader(study, from, site, warnings).read();
}

}  // namespace talus::calibration
