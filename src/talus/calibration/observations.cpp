#include "talus/calibration/observations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "talus/calibration/observation_table.hpp"
#include "talus/calibration/observed_places.hpp"
#include "talus/core/nearest.hpp"
#include "talus/statistics/without_rounding.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;

/// The first coordinates, as a row of a sample.
Eigen::RowVectorXd row_of(const Vec2& place, Index features) {
  return Eigen::Map<const Eigen::RowVectorXd>(place.data(), features);
}

/// By LineValue.
const std::vector<ObservedColumn> value_columns{
    {"height_m", {"impact_height_m"}}, {"velocity_m_s", {"speed_m_s"}}, {"energy_kJ", {}}};

/// Puts the rows of one rock next to each other, in the order in which the rocks are first named.
void group_by_rock(std::vector<ObservedPlace>& places, std::vector<std::uint32_t>& rocks) {
  std::map<std::string, std::uint32_t> numbers;
  for (const ObservedPlace& place : places) numbers.try_emplace(place.rock, static_cast<std::uint32_t>(numbers.size()));
  std::ranges::stable_sort(places, {}, [&](const ObservedPlace& place) { return numbers.at(place.rock); });
  for (const ObservedPlace& place : places) rocks.push_back(numbers.at(place.rock));
}

void check_rocks(const std::vector<ObservedPlace>& places, const std::string& file) {
  const auto named = std::ranges::count_if(places, [](const ObservedPlace& place) { return !place.rock.empty(); });
  if (named == 0 || static_cast<std::size_t>(named) == places.size()) return;
  throw BadInput(
      Problem{.file = file,
              .what = fmt::format("{} of {} marks ha{} a rock", named, places.size(), named == 1 ? "s" : "ve"),
              .why = "either all or none",
              .hint = "Put marks of unknown rocks into another file"});
}

void check_releases_of_rocks(const std::vector<ObservedPlace>& places) {
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (places[k].rock.empty() || places[k].rock != places[k - 1].rock || places[k].release == places[k - 1].release) {
      continue;
    }
    Problem problem = places[k].place;
    problem.what = fmt::format("rock \"{}\" has the releases \"{}\" and \"{}\"", places[k].rock, places[k - 1].release,
                               places[k].release);
    problem.why = "a rock has one";
    throw BadInput(std::move(problem));
  }
}

void take_places(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
                 ObservedGroup& group, Problems& warnings) {
  std::vector<ObservedPlace> places = read_places(study, from, site, warnings);
  const std::string file = (study.file.parent_path() / from.file()).string();
  if (group.kind == ObservationKind::marks) {
    check_rocks(places, file);
    if (!places.front().rock.empty()) group_by_rock(places, group.sample.rocks);
    check_releases_of_rocks(places);
  }
  const std::vector<study::RockEnd> ends = site.run({}, {}).ends;
  MatchedPlaces matched = match_places(places, site, ends, file, warnings);
  group.releases = std::move(matched.strata);
  group.sample.strata = std::move(matched.of_place);
  std::size_t compared = 0;
  Vec2 mean_end;
  for (const study::RockEnd& end : ends) {
    if (group.releases.of(end) == ReleaseStrata::none) continue;
    group.axis.origin += end.release.xy();
    mean_end += end.end.xy();
    ++compared;
  }
  group.axis.origin /= static_cast<double>(compared);
  mean_end /= static_cast<double>(compared);
  // The direction is that of the rocks of the project as it is. It does not follow from the observed places, so that
  // predictions of a site that is held out do not depend on them.
  const Vec2 way = mean_end - group.axis.origin;
  if (without_rounding(way.norm(), 1 + mean_end.norm()) > 0) group.axis.along = way.normalized();
  const bool is_2d = site.project().is_2d();
  group.features = {{"runout", "m", from.accuracy_m}};
  if (!is_2d) group.features.push_back({"lateral", "m", from.accuracy_m});
  group.sample.rows.resize(static_cast<Index>(places.size()), static_cast<Index>(group.features.size()));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec2 at = group.place_of(places[k].position, group.sample.has_strata() ? group.sample.strata[k] : 0);
    group.sample.rows.row(static_cast<Index>(k)) = row_of(at, group.sample.rows.cols());
  }
}

/// Energies and velocities imply masses: those of simulated rocks, or a unit is wrong.
void check_units(const ObservedGroup& group, const study::PreparedSite& site, const std::string& file,
                 Problems& warnings) {
  const auto column_of = [&](LineValue value) -> std::optional<Index> {
    const auto found = std::ranges::find(group.values, value);
    return found == group.values.end() ? std::nullopt : std::optional(found - group.values.begin());
  };
  const auto velocity = column_of(LineValue::velocity), energy = column_of(LineValue::energy);
  if (!velocity || !energy) return;
  std::vector<double> implied, masses;
  for (Index row = 0; row < group.sample.rows.rows(); ++row) {
    const double v = group.sample.rows(row, *velocity);
    if (v > 0) implied.push_back(2000 * group.sample.rows(row, *energy) / (v * v));
  }
  for (const study::RockEnd& end : site.run({}, {}).ends) masses.push_back(end.mass);
  if (implied.empty() || masses.empty()) return;
  std::ranges::sort(implied);
  const auto [least, most] = std::ranges::minmax(masses);
  const double median = implied[implied.size() / 2];
  constexpr double rotation = 1.4;  // of a rolling sphere: translational and rotational energy over translational
  constexpr double far = 4;
  if (median < far * rotation * most && median * far > least) return;
  warnings.add({Severity::warning, file, 0, "",
                fmt::format("the energies and velocities imply rocks of {:.3g} kg", median),
                fmt::format("the simulated rocks have {}", mass_range(least, most)),
                "Check the units, kJ and m/s, and the sizes of the seeders"});
}

void take_values(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
                 ObservedGroup& group, Problems& warnings) {
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
                           .hint = near ? fmt::format("Did you mean \"{}\"?", *near)
                                        : fmt::format("Add a [[collector]] \"{}\" to the project", from.at)});
  }
  group.barrier = BarrierId{static_cast<std::uint32_t>(found - names.begin())};
  const ObservationTable table(study.file.parent_path() / from.values);
  Problems problems;
  table.check_columns(value_columns, problems, warnings);
  std::vector<std::size_t> columns;
  const auto take = [&](LineValue value, Feature feature) {
    const auto place = table.find(value_columns[static_cast<std::size_t>(value)]);
    if (!place) return;
    columns.push_back(*place);
    group.values.push_back(value);
    group.features.push_back(std::move(feature));
  };
  take(LineValue::height, {"height", "m", from.accuracy_m});
  take(LineValue::velocity, {"velocity", "m/s", 0});
  take(LineValue::energy, {"energy", "kJ", 0});
  if (problems.has_errors()) throw BadInput(std::move(problems));
  if (columns.empty()) {
    throw BadInput(Problem{.file = table.file(),
                           .line = 1,
                           .what = "there is no column of values",
                           .why = fmt::format("the columns are {}", fmt::join(table.columns(), ", ")),
                           .hint = "Name them height_m, velocity_m_s or energy_kJ"});
  }
  group.sample.rows.resize(static_cast<Eigen::Index>(table.rows()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double value = table.number(row, columns[k], problems).value_or(0);
      group.sample.rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) = value;
      if (value >= 0) continue;
      Problem problem = table.at(row);
      problem.what = fmt::format("{} is {:g}", table.columns()[columns[k]], value);
      problem.why = "expected 0 or more";
      problems.add(std::move(problem));
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  check_units(group, site, table.file(), warnings);
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

/// Of simulated stops or marks: places with the rocks that left them.
template <class Place, class PositionOf>
Sample sample_of_places(const ObservedGroup& group, const study::SetOutcome& outcome, const std::vector<Place>& places,
                        PositionOf&& position_of) {
  std::vector<std::pair<const Place*, std::uint32_t>> compared;
  for (const Place& place : places) {
    const std::uint32_t stratum = group.releases.of(outcome.ends[place.rock]);
    if (stratum != ReleaseStrata::none) compared.emplace_back(&place, stratum);
  }
  Sample sample;
  const auto features = static_cast<Index>(group.features.size());
  sample.rows.resize(static_cast<Index>(compared.size()), features);
  for (std::size_t k = 0; k < compared.size(); ++k) {
    const auto& [place, stratum] = compared[k];
    sample.rows.row(static_cast<Index>(k)) = row_of(group.place_of(position_of(*place), stratum), features);
    if (group.sample.has_strata()) sample.strata.push_back(stratum);
    if (!group.sample.rocks.empty()) sample.rocks.push_back(static_cast<std::uint32_t>(place->rock));
  }
  return sample;
}

Sample sample_of_crossings(const ObservedGroup& group, const study::SetOutcome& outcome) {
  // Of a rock that arrives several times, the first arrival.
  std::vector<const study::Crossing*> first;
  for (const study::Crossing& crossing : outcome.crossings) {
    if (crossing.barrier.index != group.barrier.index) continue;
    if (first.empty() || first.back()->rock != crossing.rock) first.push_back(&crossing);
  }
  Sample sample;
  const auto features = static_cast<Index>(group.features.size());
  sample.rows.resize(static_cast<Index>(first.size()), features);
  for (Index row = 0; row < sample.rows.rows(); ++row) {
    for (Index f = 0; f < features; ++f) {
      sample.rows(row, f) = value_of(group.values[static_cast<std::size_t>(f)], *first[static_cast<std::size_t>(row)]);
    }
  }
  return sample;
}

}  // namespace

Vec2 ObservedGroup::place_of(const Vec3& position, std::uint32_t stratum) const {
  // Runouts are counted from a rock's own release.
  const Vec2 shift = releases.origins.empty() ? Vec2{} : releases.origins[stratum] - axis.origin;
  return axis.of(position.xy() - shift);
}

ObservedGroup read_observations(const Study& study, const StudyObservations& from, std::size_t site,
                                const study::PreparedSite& prepared, Problems& warnings) {
  ObservedGroup group;
  group.name = from.name;
  group.site = site;
  group.weight = from.weight;
  group.kind = !from.stops.empty()    ? ObservationKind::stops
               : !from.marks.empty()  ? ObservationKind::marks
               : !from.values.empty() ? ObservationKind::values
                                      : ObservationKind::zones;
  switch (group.kind) {
    case ObservationKind::stops:
    case ObservationKind::marks:
      take_places(study, from, prepared, group, warnings);
      break;
    case ObservationKind::values:
      take_values(study, from, prepared, group, warnings);
      break;
    case ObservationKind::zones: {
      ReadZones read = read_zones(study, from, prepared, prepared.run({}, {}).ends, warnings);
      group.zones = std::move(read.zones);
      group.sample = std::move(read.sample);
      break;
    }
  }
  return group;
}

Sample simulated_sample(const ObservedGroup& group, const study::SetOutcome& outcome) {
  switch (group.kind) {
    case ObservationKind::stops:
      return sample_of_places(group, outcome, outcome.ends, [](const study::RockEnd& end) { return end.end; });
    case ObservationKind::marks:
      return sample_of_places(group, outcome, outcome.marks, [](const study::Mark& mark) { return mark.position; });
    case ObservationKind::values:
      return sample_of_crossings(group, outcome);
    case ObservationKind::zones:
      break;
  }
  return zone_sample(group.zones, outcome.ends);
}

}  // namespace talus::calibration
