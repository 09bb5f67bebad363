#include "talus/calibration/observations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "talus/calibration/observation_table.hpp"
#include "talus/core/nearest.hpp"
#include "talus/import/vector_file.hpp"

namespace talus::calibration {

namespace {

constexpr std::size_t most_places_reported = 5;
constexpr double far_off_the_ground = 1;  // [m]

bool is_text_table(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".csv" || ending == ".txt" || ending == ".tsv";
}

/// Stops as in the file.
struct ReadStop {
  Vec3 position = Vec3::Zero();
  bool has_z = false;
  std::string release;
  Problem place;  // of the row, for messages
};

class StopReader {
 public:
  StopReader(const Study& study, const StudyObservations& from, const study::PreparedSite& site, Problems& warnings)
      : from_(from),
        site_(site),
        is_2d_(site.project().is_2d()),
        file_(study.file.parent_path() / from.file()),
        warnings_(warnings) {}

  std::vector<ReadStop> read() {
    std::vector<ReadStop> stops = is_text_table(file_) ? from_table() : from_map();
    check_places(stops);
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    return stops;
  }

  /// The seeder of each stop, if all name one; empty if none does.
  std::vector<std::uint32_t> seeders_of(const std::vector<ReadStop>& stops) {
    std::vector<std::uint32_t> seeders;
    const auto& known = site_.model().seeders;
    std::vector<std::string_view> names;
    for (const Seeder& seeder : known) names.push_back(seeder.name);
    for (const ReadStop& stop : stops) {
      if (stop.release.empty()) continue;
      const auto found = std::ranges::find(names, stop.release);
      if (found == names.end()) {
        Problem problem = stop.place;
        problem.what = fmt::format("there is no seeder \"{}\"", stop.release);
        problem.why = "the column release names the seeder of the rock";
        if (const auto near = nearest(stop.release, names)) problem.hint = fmt::format("Did you mean \"{}\"?", *near);
        problems_.add(std::move(problem));
        continue;
      }
      seeders.push_back(static_cast<std::uint32_t>(found - names.begin()));
    }
    if (!seeders.empty() && seeders.size() != stops.size() && !problems_.has_errors()) {
      problems_.add({.file = file_.string(),
                     .what = fmt::format("{} of {} rocks have a release", seeders.size(), stops.size()),
                     .why = "either all or none"});
    }
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    return seeders;
  }

 private:
  std::vector<ReadStop> from_table() {
    const ObservationTable table(file_);
    const auto x = table.find({"x_m", "x"}), y = table.find({"y_m", "y"}), z = table.find({"z_m", "z"}),
               release = table.find({"release", "seeder"});
    if (!x || (!y && !is_2d_)) {
      throw BadInput(Problem{.file = table.file(),
                             .line = 1,
                             .what = fmt::format("there is no column {}", !x ? "x_m" : "y_m"),
                             .why = fmt::format("the columns are {}", fmt::join(table.columns(), ", ")),
                             .hint = "Name the columns of the coordinates x_m and y_m, in metres"});
    }
    std::vector<ReadStop> stops;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      ReadStop stop;
      stop.place = table.at(row);
      stop.has_z = z && !table.text(row, *z).empty();
      stop.position.x() = table.number(row, *x, problems_).value_or(0);
      if (!is_2d_) stop.position.y() = table.number(row, *y, problems_).value_or(0);
      if (stop.has_z) stop.position.z() = table.number(row, *z, problems_).value_or(0);
      if (release && from_.marks.empty()) stop.release = table.text(row, *release);
      stops.push_back(std::move(stop));
    }
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    return stops;
  }

  std::vector<ReadStop> from_map() {
    if (is_2d_) {
      throw BadInput(Problem{.file = file_.string(),
                             .what = "points of a map cannot be compared with a section",
                             .why = "expected a CSV file with the column x_m"});
    }
    const VectorRequest request{.layer = from_.layer,
                                .attributes = {},
                                .kinds = {ShapeKind::point},
                                .polygons_are_in_space = false,
                                .heights_are_used = false,
                                .terrain_crs_wkt = site_.model().crs_wkt};
    std::vector<ReadStop> stops;
    for (const VectorFeature& feature : read_vector_file(file_, request, warnings_).features) {
      for (const VectorShape& part : feature.parts) {
        ReadStop stop;
        stop.position = part.lists.front().front();
        stop.has_z = feature.has_z;
        stop.place = {.file = file_.string(), .where = fmt::format("feature {}", feature.id)};
        stops.push_back(std::move(stop));
      }
    }
    return stops;
  }

  std::optional<double> elevation(const Vec3& at) const {
    const Vec3 local = site_.model().frame.local_from_global(at);
    const auto z =
        std::visit([&](const auto& surface) { return surface.elevation(local.x(), local.y()); }, site_.model().surface);
    if (!z) return std::nullopt;
    return *z + site_.model().frame.origin.z();
  }

  void check_places(const std::vector<ReadStop>& stops) {
    std::size_t off = 0, swapped = 0, high = 0;
    double most = 0;
    for (const ReadStop& stop : stops) {
      const auto ground = elevation(stop.position);
      if (!ground) {
        if (elevation({stop.position.y(), stop.position.x(), 0})) ++swapped;
        if (++off > most_places_reported) continue;
        Problem problem = stop.place;
        problem.what = is_2d_
                           ? fmt::format("x = {:.10g} is off the terrain", stop.position.x())
                           : fmt::format("({:.10g}, {:.10g}) is off the terrain", stop.position.x(), stop.position.y());
        problem.why = extent();
        problems_.add(std::move(problem));
      } else if (stop.has_z && std::abs(stop.position.z() - *ground) > far_off_the_ground) {
        ++high;
        most = std::max(most, std::abs(stop.position.z() - *ground));
      }
    }
    if (off > 0) {
      problems_.add({.file = file_.string(),
                     .what = fmt::format("{} of {} observations are off the terrain", off, stops.size()),
                     .why = off == stops.size() ? "they may be in another coordinate system" : "",
                     .hint = swapped == off && !is_2d_ ? "x and y seem to be exchanged" : ""});
    }
    if (high > 0) {
      warnings_.add({Severity::warning, file_.string(), 0, "",
                     fmt::format("{} of {} observed {} are more than {:g} m above or below the terrain", high,
                                 stops.size(), from_.marks.empty() ? "stops" : "marks", far_off_the_ground),
                     fmt::format("up to {:.1f} m", most), "Compare their heights and coordinates with the terrain"});
    }
  }

  std::string extent() const {
    const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, site_.model().surface);
    const Vec3 low = site_.model().frame.global_from_local(box.low);
    const Vec3 high = site_.model().frame.global_from_local(box.high);
    if (is_2d_) return fmt::format("the section extends from x = {:.10g} to {:.10g}", low.x(), high.x());
    return fmt::format("on plan the terrain lies within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}", low.x(),
                       high.x(), low.y(), high.y());
  }

  const StudyObservations& from_;
  const study::PreparedSite& site_;
  bool is_2d_;
  std::filesystem::path file_;
  Problems& warnings_;
  Problems problems_;
};

void take_stops(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
                ObservedGroup& group, Problems& warnings) {
  StopReader reader(study, from, site, warnings);
  const std::vector<ReadStop> stops = reader.read();
  group.sample.strata = reader.seeders_of(stops);
  Vec2 mean_stop = Vec2::Zero();
  for (const ReadStop& stop : stops) {
    mean_stop += stop.position.head<2>() / static_cast<double>(stops.size());
    group.positions.push_back(stop.position);
  }
  const study::SetOutcome once = site.run({}, {});
  for (const study::RockEnd& end : once.ends)
    group.axis.origin += end.release.head<2>() / static_cast<double>(once.ends.size());
  const Vec2 way = mean_stop - group.axis.origin;
  if (way.norm() > 0) group.axis.along = way.normalized();
  const bool is_2d = site.project().is_2d();
  group.features = {{"runout", "m", from.accuracy_m}};
  if (!is_2d) group.features.push_back({"lateral", "m", from.accuracy_m});
  group.sample.rows.resize(static_cast<Eigen::Index>(stops.size()), static_cast<Eigen::Index>(group.features.size()));
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const Vec2 at = group.axis.of(stops[k].position);
    const auto row = static_cast<Eigen::Index>(k);
    group.sample.rows(row, 0) = at.x();
    if (!is_2d) group.sample.rows(row, 1) = at.y();
  }
}

void take_values(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
                 ObservedGroup& group) {
  std::vector<std::string_view> names;
  for (const Barrier& barrier : site.model().barriers) names.push_back(barrier.name);
  const auto found = std::ranges::find(names, from.at);
  if (found == names.end()) {
    const auto near = nearest(from.at, names);
    throw BadInput(Problem{.file = study.file.string(),
                           .line = from.line,
                           .where = fmt::format("observations \"{}\"", from.name),
                           .what = fmt::format("at is \"{}\"", from.at),
                           .why = "the project has no collector or barrier of this name",
                           .hint = near ? fmt::format("Did you mean \"{}\"?", *near) : ""});
  }
  group.barrier = BarrierId{static_cast<std::uint32_t>(found - names.begin())};
  const ObservationTable table(study.file.parent_path() / from.values);
  std::vector<std::size_t> columns;
  const auto take = [&](LineValue value, std::initializer_list<std::string_view> column, Feature feature) {
    const auto place = table.find(column);
    if (!place) return;
    columns.push_back(*place);
    group.values.push_back(value);
    group.features.push_back(std::move(feature));
  };
  take(LineValue::height, {"height_m", "impact_height_m"}, {"height", "m", from.accuracy_m});
  take(LineValue::velocity, {"velocity_m_s", "speed_m_s"}, {"velocity", "m/s", 0});
  take(LineValue::energy, {"energy_kJ"}, {"energy", "kJ", 0});
  if (columns.empty()) {
    throw BadInput(Problem{.file = table.file(),
                           .line = 1,
                           .what = "there is no column of values",
                           .why = fmt::format("the columns are {}", fmt::join(table.columns(), ", ")),
                           .hint = "Name them height_m, velocity_m_s or energy_kJ"});
  }
  Problems problems;
  group.sample.rows.resize(static_cast<Eigen::Index>(table.rows()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      group.sample.rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) =
          table.number(row, columns[k], problems).value_or(0);
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

double value_of(LineValue value, const study::Crossing& crossing) {
  switch (value) {
    case LineValue::height:
      return crossing.height;
    case LineValue::velocity:
      return crossing.speed;
    case LineValue::energy:
      break;
  }
  return (crossing.translational_energy + crossing.rotational_energy) / 1000;
}

}  // namespace

ObservedGroup read_observations(const Study& study, const StudyObservations& from, std::size_t site,
                                const study::PreparedSite& prepared, Problems& warnings) {
  ObservedGroup group;
  group.name = from.name;
  group.site = site;
  group.weight = from.weight;
  group.kind = !from.stops.empty()   ? ObservationKind::stops
               : !from.marks.empty() ? ObservationKind::marks
                                     : ObservationKind::values;
  if (group.kind != ObservationKind::values) {
    take_stops(study, from, prepared, group, warnings);
  } else {
    take_values(study, from, prepared, group);
  }
  return group;
}

Sample simulated_sample(const ObservedGroup& group, const study::SetOutcome& outcome) {
  Sample sample;
  const auto features = static_cast<Eigen::Index>(group.features.size());
  if (group.kind == ObservationKind::stops) {
    sample.rows.resize(static_cast<Eigen::Index>(outcome.ends.size()), features);
    for (Eigen::Index row = 0; row < sample.rows.rows(); ++row) {
      const study::RockEnd& end = outcome.ends[static_cast<std::size_t>(row)];
      const Vec2 at = group.axis.of(end.end);
      for (Eigen::Index f = 0; f < features; ++f) sample.rows(row, f) = at[f];
      if (!group.sample.strata.empty()) sample.strata.push_back(end.seeder.index);
    }
    return sample;
  }
  if (group.kind == ObservationKind::marks) {
    sample.rows.resize(static_cast<Eigen::Index>(outcome.marks.size()), features);
    for (Eigen::Index row = 0; row < sample.rows.rows(); ++row) {
      const Vec2 at = group.axis.of(outcome.marks[static_cast<std::size_t>(row)].position);
      for (Eigen::Index f = 0; f < features; ++f) sample.rows(row, f) = at[f];
    }
    return sample;
  }
  // Of a rock that arrives several times, the first arrival.
  std::vector<const study::Crossing*> first;
  for (const study::Crossing& crossing : outcome.crossings) {
    if (crossing.barrier.index != group.barrier.index) continue;
    if (first.empty() || first.back()->rock != crossing.rock) first.push_back(&crossing);
  }
  sample.rows.resize(static_cast<Eigen::Index>(first.size()), features);
  for (Eigen::Index row = 0; row < sample.rows.rows(); ++row) {
    for (Eigen::Index f = 0; f < features; ++f) {
      sample.rows(row, f) = value_of(group.values[static_cast<std::size_t>(f)], *first[static_cast<std::size_t>(row)]);
    }
  }
  return sample;
}

}  // namespace talus::calibration
