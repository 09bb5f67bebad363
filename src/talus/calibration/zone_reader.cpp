#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "talus/calibration/observation_table.hpp"
#include "talus/calibration/observed_places.hpp"
#include "talus/calibration/zone_checks.hpp"
#include "talus/files/data_table.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/project/values.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;

const std::vector<ObservedColumn> zone_columns{{"zone", {"name"}},   {"x_m", {"x"}}, {"y_m", {"y"}},
                                               {"from_m", {}},       {"to_m", {}},   {"volume_m3", {}},
                                               {"count", {"rocks"}}, {"share", {}}};
enum ZoneColumn : std::size_t { name_column, x_column, y_column, from_column, to_column, first_amount };

class ZoneReader {
 public:
  ZoneReader(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
             const std::vector<study::RockEnd>& ends, Problems& warnings)
      : study_(study),
        from_(from),
        site_(site),
        ends_(ends),
        is_2d_(site.project().is_2d()),
        file_(study.file.parent_path() / from.zones),
        warnings_(warnings) {}

  ReadZones read() {
    if (is_text_table(file_)) {
      from_table();
    } else {
      from_map();
    }
    throw_if_any();
    check_amounts();
    throw_if_any();
    ReadZones read;
    read.sample = sample();
    throw_if_any();
    read.zones = std::move(zones_);
    return read;
  }

 private:
  struct Amount {
    std::size_t column = 0;
    ZoneAmount kind = ZoneAmount::volume;
  };

  /// The only one of the columns volume_m3, count and share that is there.
  template <class Find>
  std::optional<Amount> amount_column(Find&& find) {
    std::optional<Amount> found;
    for (const ZoneAmount kind : {ZoneAmount::volume, ZoneAmount::count, ZoneAmount::share}) {
      const auto column = find(zone_columns[first_amount + static_cast<std::size_t>(kind)]);
      if (!column) continue;
      if (found) {
        refuse(1, "there are several of the columns volume_m3, count and share", "it is not clear which was observed",
               "Keep one");
        return std::nullopt;
      }
      found = Amount{*column, kind};
    }
    if (!found) {
      refuse(1, "there is no column volume_m3, count or share", "",
             "Say how much came to rest in each zone: volume_m3 (its volume), count (its rocks) or share (of all that "
             "was released)");
    } else {
      zones_.amount = found->kind;
    }
    return found;
  }

  void from_table() {
    const ObservationTable table(file_);
    table.check_columns(zone_columns, problems_, warnings_);
    const auto find = [&](const ObservedColumn& column) { return table.find(column); };
    const auto name = find(zone_columns[name_column]);
    const auto x = find(zone_columns[is_2d_ ? from_column : x_column]);
    const auto y = find(zone_columns[is_2d_ ? to_column : y_column]);
    throw_if_any();
    if (!name || !x || !y) {
      refuse(1,
             fmt::format("there is no column {}", !name    ? "zone"
                                                  : is_2d_ ? (!x ? "from_m" : "to_m")
                                                           : (!x ? "x_m" : "y_m")),
             fmt::format("the columns are {}", fmt::join(table.columns(), ", ")),
             is_2d_
                 ? "A row is a zone: zone, from_m, to_m along the section, and its amount"
                 : "A row is a vertex of a zone's outline: zone, x_m, y_m, and the zone's amount in one of its rows");
      throw_if_any();
    }
    const auto amount = amount_column(find);
    throw_if_any();
    std::map<std::string, std::size_t> numbers;
    std::vector<std::vector<Vec3>> outlines;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::string& zone = table.text(row, *name);
      const auto [known, is_new] = numbers.try_emplace(zone, zones_.list.size());
      if (is_new) {
        zones_.list.push_back({.name = zone, .amount = NAN});
        places_.push_back(table.at(row));
        outlines.emplace_back();
      } else if (is_2d_) {
        at(table.at(row), fmt::format("zone \"{}\" is given twice", zone), "a row is a zone", "");
      }
      ObservedZone& one = zones_.list[known->second];
      const double first = table.number(row, *x, problems_).value_or(0);
      const double second = table.number(row, *y, problems_).value_or(0);
      if (is_2d_) {
        one.from = first;
        one.to = second;
      } else {
        outlines[known->second].emplace_back(first, second, 0);
      }
      if (table.text(row, amount->column).empty()) continue;
      const double own = table.number(row, amount->column, problems_).value_or(0);
      if (one.amount == one.amount && one.amount != own) {
        at(table.at(row), fmt::format("zone \"{}\" has the amounts {:g} and {:g}", zone, one.amount, own),
           "a zone has one", "Give it in one of its rows");
      }
      one.amount = own;
    }
    throw_if_any();
    for (std::size_t k = 0; k < zones_.list.size(); ++k) {
      if (!is_2d_) add_polygon(k, {outlines[k]});
    }
    throw_if_any();
    check_zone_places(zones_.list, places_, site_, problems_, warnings_);
  }

  void from_map() {
    if (is_2d_) {
      refuse(0, "polygons of a map cannot be compared with a section", "",
             "Write a CSV file with the columns zone, from_m, to_m and volume_m3");
      throw_if_any();
    }
    std::vector<std::string> names;
    const VectorRequest request{.layer = from_.layer,
                                .attributes = {},
                                .kinds = {ShapeKind::polygon},
                                .polygons_are_in_space = false,
                                .heights_are_used = false,
                                .terrain_crs_wkt = site_.model().crs_wkt,
                                .choose = [&](const std::vector<std::string>& all) { return names = all; }};
    const VectorLayer layer = read_vector_file(file_, request, warnings_);
    std::vector<ObservedColumn> attributes = zone_columns;
    attributes.erase(attributes.begin() + x_column, attributes.begin() + first_amount);  // places: the polygons
    check_column_names({.file = file_.string()}, names, attributes, problems_, warnings_);
    const auto find = [&](const ObservedColumn& column) -> std::optional<std::size_t> {
      for (std::size_t k = 0; k < names.size(); ++k) {
        if (column.is_named(names[k])) return k;
      }
      return std::nullopt;
    };
    const auto name = find(zone_columns[name_column]);
    const auto amount = amount_column(find);
    throw_if_any();
    for (const VectorFeature& feature : layer.features) {
      const Problem place{.file = file_.string(), .where = fmt::format("feature {}", feature.id)};
      ObservedZone zone;
      zone.name = name && feature.values[*name] ? *feature.values[*name] : fmt::format("feature {}", feature.id);
      const auto& text = feature.values[amount->column];
      const auto own = text ? number_in_cell(*text, false) : std::nullopt;
      zone.amount = own.value_or(NAN);
      if (text && !own) at(place, fmt::format("the amount is \"{}\"", *text), "expected a number", "");
      zones_.list.push_back(std::move(zone));
      places_.push_back(place);
      for (const VectorShape& part : feature.parts) add_polygon(zones_.list.size() - 1, part.lists);
    }
    throw_if_any();
    check_zone_places(zones_.list, places_, site_, problems_, warnings_);
  }

  void add_polygon(std::size_t k, const std::vector<std::vector<Vec3>>& rings) {
    std::vector<Vec2> outer;
    for (const Vec3& p : rings.front()) outer.push_back(p.xy());
    constexpr std::size_t fewest = 3;
    if (outer.size() > 1 && outer.front() == outer.back()) outer.pop_back();
    if (outer.size() < fewest) {
      at(places_[k],
         fmt::format("zone \"{}\" has {}", zones_.list[k].name, project::counted(outer.size(), "vertex", "vertices")),
         "an area has three or more", "");
      return;
    }
    if (const auto crossing = self_crossing(outer)) {
      at(places_[k], fmt::format("the outline of zone \"{}\" crosses itself", zones_.list[k].name),
         fmt::format("at ({:.10g}, {:.10g})", crossing->x(), crossing->y()),
         "Give the vertices in their order along the outline");
      return;
    }
    std::vector<std::vector<Vec3>> all = rings;
    all.front().resize(outer.size());
    zones_.list[k].polygons.emplace_back(all);
    zones_.list[k].outlines.push_back(std::move(outer));
  }

  void check_amounts() {
    for (std::size_t k = 0; k < zones_.list.size(); ++k) {
      const ObservedZone& zone = zones_.list[k];
      const bool is_whole = zones_.amount != ZoneAmount::count || zone.amount == std::floor(zone.amount);
      if (zone.amount >= 0 && std::isfinite(zone.amount) && is_whole) continue;
      at(places_[k],
         std::isnan(zone.amount) ? fmt::format("zone \"{}\" has no amount", zone.name)
                                 : fmt::format("zone \"{}\" has the amount {:g}", zone.name, zone.amount),
         is_whole ? "expected 0 or more" : "expected a number of rocks", "Write 0 where nothing came to rest");
    }
    throw_if_any();
    for (const ObservedZone& zone : zones_.list) zones_.total += zone.amount;
    if (!(zones_.total > 0)) {
      refuse(0, "the zones are all empty", "there is nothing to compare", "");
      return;
    }
    constexpr double rounding = 1.001;
    zones_.released = from_.released;
    if (zones_.amount == ZoneAmount::share) {
      zones_.released = 1;
      if (zones_.total > rounding) {
        refuse(0, fmt::format("the shares add up to {:g}", zones_.total), "they are shares of all that was released",
               zones_.total > 50 && zones_.total < 101 ? "Divide percentages by 100"
                                                       : "Give volumes or counts instead: volume_m3 or count");
      }
      if (from_.released)
        at_key("released is given with shares", "shares are of all that was released", "Leave it out");
      if (!from_.blocks) {
        at_key("blocks is missing", "a share says nothing of how many rocks it was counted from",
               "Write blocks = the number of rocks that were released");
      }
    } else if (zones_.released && zones_.total > rounding * *zones_.released) {
      at_key(fmt::format("the zones hold {:g} {}, but released is {:g}", zones_.total, zones_.unit(), *zones_.released),
             "no more can come to rest than was released", "Check the units of both");
    }
    if (zones_.amount == ZoneAmount::count && from_.blocks) {
      at_key("blocks is given with counts", "they are the numbers of rocks", "Leave it out");
    }
    zones_.has_elsewhere = zones_.released.has_value();
    zones_.relative_accuracy = zones_.amount == ZoneAmount::count ? 0 : from_.relative_accuracy;
    if (!zones_.has_elsewhere && zones_.list.size() < 2) {
      refuse(0, "there is one zone", "its share of what the zones hold is 1 whatever the parameters",
             "Write released = the volume or count of all rocks, or add zones");
    }
  }

  /// Rocks of equal amounts, as many as make the volumes vary as those of simulated rocks would.
  Sample sample() {
    double sum = 0, squares = 0;
    for (const study::RockEnd& end : ends_) {
      const double own = zones_.amount_of(end);
      sum += own;
      squares += own * own;
    }
    const double all = zones_.released.value_or(zones_.total);
    const double rocks = zones_.amount == ZoneAmount::count ? all : from_.blocks.value_or(all * sum / squares);
    constexpr double fewest = 1, suspiciously_many = 1e5, most = 1e6;
    const double mean = sum / static_cast<double>(ends_.size());
    if (rocks < fewest || rocks > most) {
      refuse(0, fmt::format("the zones hold {:.4g} m3, as much as {:.3g} simulated rocks", zones_.total, rocks),
             fmt::format("a simulated rock has {:.3g} m3 in the mean", mean),
             "Check the unit of volume_m3 and the sizes of the seeders, or write blocks = the number of rocks");
      return {};
    }
    if (rocks > suspiciously_many) {
      warnings_.add({Severity::warning, file_.string(), 0, "",
                     fmt::format("the zones hold as much as {:.3g} simulated rocks", rocks),
                     fmt::format("a simulated rock has {:.3g} m3 in the mean", mean),
                     "Check the unit of volume_m3 and the sizes of the seeders"});
    }
    std::vector<std::pair<double, double>> rows;
    for (std::size_t k = 0; k < zones_.category_count(); ++k) {
      const double amount = k < zones_.list.size() ? zones_.list[k].amount : std::max(all - zones_.total, 0.0);
      if (!(amount > 1e-9 * all)) continue;
      const double parts = std::max(1.0, std::round(rocks * amount / all));
      for (double part = 0; part < parts; ++part) rows.emplace_back(static_cast<double>(k), amount / parts);
    }
    Sample sample;
    sample.rows.resize(static_cast<Index>(rows.size()), 2);
    for (std::size_t k = 0; k < rows.size(); ++k)
      sample.rows.row(static_cast<Index>(k)) = Eigen::RowVector2d(rows[k].first, rows[k].second);
    return sample;
  }

  void refuse(int line, std::string what, std::string why, std::string hint) {
    at({.file = file_.string(), .line = line}, std::move(what), std::move(why), std::move(hint));
  }
  void at(Problem place, std::string what, std::string why, std::string hint) {
    place.what = std::move(what);
    place.why = std::move(why);
    place.hint = std::move(hint);
    problems_.add(std::move(place));
  }
  void at_key(std::string what, std::string why, std::string hint) {
    at({.file = study_.file.string(), .line = from_.line, .where = fmt::format("observations \"{}\"", from_.name)},
       std::move(what), std::move(why), std::move(hint));
  }
  void throw_if_any() {
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
  }

  const Study& study_;
  const StudyObservations& from_;
  const study::PreparedSite& site_;
  const std::vector<study::RockEnd>& ends_;
  bool is_2d_;
  std::filesystem::path file_;
  Problems& warnings_;
  Problems problems_;
  ObservedZones zones_;
  std::vector<Problem> places_;  // of each zone, for messages
};

}  // namespace

ReadZones read_zones(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
                     const std::vector<study::RockEnd>& ends, Problems& warnings) {
  return ZoneReader(study, from, site, ends, warnings).read();
}

}  // namespace talus::calibration
