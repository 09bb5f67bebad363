#include "talus/calibration/releases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "talus/core/nearest.hpp"
#include "talus/project/values.hpp"

namespace talus::calibration {

namespace {

using project::counted;

constexpr std::size_t fewest_simulated = 5, few_simulated = 20;  // rocks of a release
constexpr std::size_t most_releases_named = 3;                   // in a message

class ReleaseMatch {
 public:
  ReleaseMatch(const std::vector<ObservedPlace>& places, const study::PreparedSite& site,
               const std::vector<study::RockEnd>& ends, const std::string& file, Problems& warnings)
      : places_(places), site_(site), ends_(ends), file_(file), warnings_(warnings) {}

  MatchedPlaces by_name() {
    find_names();
    MatchedPlaces matched;
    ReleaseStrata& strata = matched.strata;
    std::map<std::string, std::uint32_t> numbers;
    std::map<std::string, std::size_t> unknown;  // rows
    std::vector<const ObservedPlace*> first_unknown;
    std::size_t named = 0;
    for (const ObservedPlace& place : places_) {
      if (place.release.empty()) continue;
      ++named;
      if (!releases_.contains(place.release)) {
        if (unknown[place.release]++ == 0) first_unknown.push_back(&place);
        continue;
      }
      const auto [known, is_new] = numbers.try_emplace(place.release, static_cast<std::uint32_t>(strata.names.size()));
      if (is_new) strata.names.push_back(place.release);
      matched.of_place.push_back(known->second);
    }
    for (const ObservedPlace* place : first_unknown) refuse_unknown(*place, unknown.at(place->release) - 1);
    if (named != places_.size() && !problems_.has_errors()) {
      problems_.add(
          {.file = file_,
           .what = fmt::format("{} of {} rocks ha{} a release", named, places_.size(), named == 1 ? "s" : "ve"),
           .why = "either all or none",
           .hint = "Put rocks of unknown releases into another file, as observations of their own"});
    }
    throw_if_any();
    assign_rocks(numbers, strata);
    throw_if_any();
    check_counts(strata);
    check_masses(matched);
    throw_if_any();
    return matched;
  }

  MatchedPlaces by_mass() {
    const auto given =
        std::ranges::count_if(places_, [](const ObservedPlace& place) { return place.mass.has_value(); });
    if (given == 0) return {};
    if (static_cast<std::size_t>(given) != places_.size()) {
      warn(fmt::format("{} of {} rocks ha{} a mass", given, places_.size(), given == 1 ? "s" : "ve"),
           "masses are used if all are known, and are not used here", "Put the others into another file");
      return {};
    }
    std::vector<double> observed, simulated;
    for (const ObservedPlace& place : places_) observed.push_back(*place.mass);
    for (const study::RockEnd& end : ends_) simulated.push_back(end.mass);
    std::ranges::sort(observed);
    std::ranges::sort(simulated);
    constexpr double outside = 1.5;
    if (observed.back() > outside * simulated.back() || observed.front() * outside < simulated.front()) {
      warn(fmt::format("the observed masses are {}, the simulated ones {}",
                       mass_range(observed.front(), observed.back()), mass_range(simulated.front(), simulated.back())),
           "rocks of other masses may run otherwise", "Check the unit, and give the seeders the observed masses");
    }
    MatchedPlaces matched;
    matched.strata.mass_bounds = bounds_between(observed, simulated);
    if (matched.strata.mass_bounds.empty()) {
      warn("the masses are not used", "too few observed or simulated rocks differ in mass",
           "Give the seeders a distribution of the mass");
      return {};
    }
    for (const ObservedPlace& place : places_) matched.of_place.push_back(matched.strata.class_of(*place.mass));
    return matched;
  }

 private:
  using Rocks = std::vector<std::uint64_t>;

  /// The rocks of each seeder, and of each name in a table of releases.
  void find_names() {
    for (const Seeder& seeder : site_.model().seeders) {
      std::map<std::string, Rocks> of_seeder;
      const ReleaseOrder order = release_order(seeder, site_.model().seed);
      for (std::uint64_t rock = seeder.first_rock; rock < seeder.first_rock + seeder.rocks; ++rock) {
        of_seeder[seeder.name].push_back(rock);
        const auto* table = std::get_if<ReleaseTable>(&*seeder.where);
        if (table == nullptr || table->names.empty()) continue;
        const std::string& name = table->names[table->number(table->row_at(order.place_of(rock))) - 1];
        if (!name.empty() && name != seeder.name) of_seeder[name].push_back(rock);
      }
      for (auto& [name, rocks] : of_seeder) {
        if (releases_.contains(name)) {
          twice_.push_back(name);
        } else {
          releases_[name] = std::move(rocks);
        }
      }
      const auto* table = std::get_if<ReleaseTable>(&*seeder.where);
      if (table == nullptr) continue;
      for (const std::string& name : table->names) {
        if (!name.empty() && !releases_.contains(name)) without_rocks_.push_back(name);
      }
    }
  }

  /// `more`: rows that name the same release.
  void refuse_unknown(const ObservedPlace& place, std::size_t more) {
    Problem problem = place.place;
    if (std::ranges::count(without_rocks_, place.release) > 0) {
      problem.what = fmt::format("the release \"{}\" has no simulated rock", place.release);
      problem.why = "the table of releases has more rows than the study has rocks";
      problem.hint = "Increase rocks of the study";
    } else {
      std::vector<std::string_view> known;
      for (const auto& [name, rocks] : releases_) known.push_back(name);
      problem.what = fmt::format("there is no release \"{}\"", place.release);
      problem.why = "the column release names a seeder, or a row of its table";
      if (const auto near = nearest(place.release, known)) problem.hint = fmt::format("Did you mean \"{}\"?", *near);
    }
    if (more > 0) problem.what += fmt::format(", which {} as well", counted(more, "row names", "rows name"));
    problems_.add(std::move(problem));
  }

  void assign_rocks(const std::map<std::string, std::uint32_t>& numbers, ReleaseStrata& strata) {
    strata.of_rock.assign(ends_.size(), ReleaseStrata::none);
    for (const auto& [name, number] : numbers) {
      if (std::ranges::count(twice_, name) > 0) {
        problems_.add({.file = file_,
                       .what = fmt::format("two seeders have a release \"{}\"", name),
                       .why = "it is not clear which one is meant",
                       .hint = "Name releases differently"});
      }
      for (const std::uint64_t rock : releases_.at(name)) {
        std::uint32_t& own = strata.of_rock[rock];
        if (own != ReleaseStrata::none) {
          problems_.add({.file = file_,
                         .what = fmt::format("\"{}\" and \"{}\" are the same releases", name, strata.names[own]),
                         .why = "one is a seeder, the other a row of its table",
                         .hint = "Name the rows, or the seeder, in all observations"});
          return;
        }
        own = number;
      }
    }
    strata.origins.assign(strata.names.size(), Vec2{});
    simulated_.assign(strata.names.size(), 0);
    for (const study::RockEnd& end : ends_) {
      const std::uint32_t own = strata.of_rock[end.rock];
      if (own == ReleaseStrata::none) continue;
      strata.origins[own] += end.release.xy();
      ++simulated_[own];
    }
    for (std::size_t k = 0; k < simulated_.size(); ++k) strata.origins[k] /= static_cast<double>(simulated_[k]);
  }

  void check_counts(const ReleaseStrata& strata) {
    const auto fewest = static_cast<std::size_t>(std::ranges::min_element(simulated_) - simulated_.begin());
    const std::size_t count = simulated_[fewest];
    if (count >= few_simulated) return;
    const double needed = std::ceil(static_cast<double>(ends_.size() * few_simulated) / static_cast<double>(count));
    Problem problem{.severity = count < fewest_simulated ? Severity::error : Severity::warning,
                    .file = file_,
                    .what = fmt::format("the release \"{}\" has {} simulated rock{}", strata.names[fewest], count,
                                        count == 1 ? "" : "s"),
                    .why = fmt::format("each observed rock is compared with those of its release: {} at least, {} are "
                                       "better",
                                       fewest_simulated, few_simulated),
                    .hint = fmt::format("Write rocks = {:.0f} in the study", needed)};
    (problem.severity == Severity::error ? problems_ : warnings_).add(std::move(problem));
  }

  /// A rock's mass against that of its own release.
  void check_masses(const MatchedPlaces& matched) {
    constexpr double differs = 1.5;
    std::size_t count = 0;
    std::string first;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (!places_[k].mass) continue;
      double least = INFINITY, most = 0;
      for (const study::RockEnd& end : ends_) {
        if (matched.strata.of_rock[end.rock] != matched.of_place[k]) continue;
        least = std::min(least, end.mass);
        most = std::max(most, end.mass);
      }
      if (*places_[k].mass <= differs * most && *places_[k].mass * differs >= least) continue;
      if (count++ == 0) {
        first = fmt::format("the rock of \"{}\" has {:.4g} kg, its release {}", places_[k].release, *places_[k].mass,
                            mass_range(least, most));
      }
    }
    if (count == 0) return;
    warn(fmt::format("{} of {} observed masses differ{} from those of their releases", count, places_.size(),
                     count == 1 ? "s" : ""),
         first, "Check the unit, and give the releases the observed masses");
  }

  /// Bounds between classes of mass.
  static std::vector<double> bounds_between(const std::vector<double>& observed, const std::vector<double>& simulated) {
    constexpr std::size_t most_classes = 4, fewest_observed = 5;
    for (std::size_t classes = std::min(most_classes, observed.size() / fewest_observed); classes > 1; --classes) {
      std::vector<double> bounds;
      for (std::size_t k = 1; k < classes; ++k) {
        const std::size_t at = k * observed.size() / classes;
        bounds.push_back(std::sqrt(observed[at - 1] * observed[at]));
      }
      const auto least_of = [&](const std::vector<double>& masses) {
        std::size_t least = masses.size(), before = 0;
        for (std::size_t k = 0; k < classes; ++k) {
          const auto end = k + 1 < classes
                               ? static_cast<std::size_t>(std::ranges::lower_bound(masses, bounds[k]) - masses.begin())
                               : masses.size();
          least = std::min(least, end - before);
          before = end;
        }
        return least;
      };
      if (least_of(observed) >= fewest_observed && least_of(simulated) >= few_simulated) return bounds;
    }
    return {};
  }

  void warn(std::string what, std::string why, std::string hint) {
    warnings_.add({Severity::warning, file_, 0, "", std::move(what), std::move(why), std::move(hint)});
  }

  void throw_if_any() {
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
  }

  const std::vector<ObservedPlace>& places_;
  const study::PreparedSite& site_;
  const std::vector<study::RockEnd>& ends_;
  const std::string& file_;
  Problems& warnings_;
  Problems problems_;
  std::map<std::string, Rocks> releases_;
  std::vector<std::string> twice_, without_rocks_;
  std::vector<std::size_t> simulated_;  // rocks, by stratum
};

}  // namespace

std::string mass_range(double least, double most) {
  const std::string from = fmt::format("{:.4g}", least), to = fmt::format("{:.4g}", most);
  return from == to ? from + " kg" : fmt::format("{} to {} kg", from, to);
}

std::string ReleaseStrata::name_of(std::uint32_t stratum) const {
  if (!names.empty()) return fmt::format("release \"{}\"", names[stratum]);
  if (mass_bounds.empty()) return "";
  if (stratum == 0) return fmt::format("rocks below {:.4g} kg", mass_bounds.front());
  if (stratum == mass_bounds.size()) return fmt::format("rocks of {:.4g} kg or more", mass_bounds.back());
  return fmt::format("rocks of {:.4g} to {:.4g} kg", mass_bounds[stratum - 1], mass_bounds[stratum]);
}

std::uint32_t ReleaseStrata::class_of(double mass) const {
  return static_cast<std::uint32_t>(std::ranges::upper_bound(mass_bounds, mass) - mass_bounds.begin());
}

std::uint32_t ReleaseStrata::of(const study::RockEnd& end) const {
  return names.empty() ? class_of(end.mass) : of_rock[end.rock];
}

MatchedPlaces match_places(const std::vector<ObservedPlace>& places, const study::PreparedSite& site,
                           const std::vector<study::RockEnd>& ends, const std::string& file, Problems& warnings) {
  ReleaseMatch match(places, site, ends, file, warnings);
  const bool is_named = std::ranges::any_of(places, [](const ObservedPlace& place) { return !place.release.empty(); });
  return is_named ? match.by_name() : match.by_mass();
}

}  // namespace talus::calibration
