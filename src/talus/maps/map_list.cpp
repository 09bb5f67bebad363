#include "talus/maps/map_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "talus/maps/map_bands.hpp"

namespace talus {

namespace {

double value_of(MapCount count, const MapTally& cell, double rocks) {
  switch (count) {
    case MapCount::passages:
      return static_cast<double>(cell.passages());
    case MapCount::reach_share:
      return static_cast<double>(cell.passages()) / rocks;
    case MapCount::deposits:
      return static_cast<double>(cell.deposits());
    case MapCount::impacts:
      return static_cast<double>(cell.impacts());
  }
  return 0;
}

bool is_share(const MapSubjectRow& row) { return row.count == MapCount::reach_share; }

MapKind kind_of_count(const MapSubjectRow& row) {
  return {std::string(row.name), std::string(row.meaning), "", row.limits, !is_share(row), MapOverview::maximum};
}

/// `part`: max, mean or a percentile.
MapKind kind_of_quantity(const MapSubjectRow& row, const std::string& part, const std::string& meaning,
                         MapOverview overview) {
  return {fmt::format("{}_{}_{}", row.name, part, row.unit_in_name),
          fmt::format("{}: {}", row.meaning, meaning),
          std::string(row.unit),
          row.limits,
          false,
          overview};
}

/// Maps whose values in a cell follow from the rocks of the run, or of an ensemble.
struct PlainGroup {
  std::vector<MapKind> kinds;
  MapCellValues values;
};

PlainGroup counts_of(const MapSubjects& subjects) {
  PlainGroup group;
  std::vector<MapCount> chosen;
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    const MapSubjectRow& row = map_subjects[k];
    if (!row.count || !subjects[k]) continue;
    chosen.push_back(*row.count);
    group.kinds.push_back(kind_of_count(row));
  }
  group.values = [chosen = std::move(chosen)](const MapTally& cell, std::uint64_t rocks, std::span<double> values) {
    for (std::size_t k = 0; k < chosen.size(); ++k) values[k] = value_of(chosen[k], cell, static_cast<double>(rocks));
  };
  return group;
}

PlainGroup group_of(const MapSubjectRow& row, const MapSelection& selection) {
  PlainGroup group;
  const auto add = [&](const std::string& part, const std::string& meaning, MapOverview overview) {
    group.kinds.push_back(kind_of_quantity(row, part, meaning, overview));
  };
  add("max", "maximum over all rocks", MapOverview::maximum);
  if (selection.means) add("mean", "mean over the rocks", MapOverview::mean);
  for (const double percent : selection.percentiles) {
    add(fmt::format("p{}", percent), fmt::format("percentile {} of the rocks", percent), MapOverview::maximum);
  }
  group.values = [quantity = *row.quantity, per = row.per, means = selection.means,
                  percentiles = selection.percentiles](const MapTally& cell, std::uint64_t, std::span<double> values) {
    values[0] = cell.maximum(quantity);
    if (means) values[1] = cell.mean(quantity);
    if (!percentiles.empty()) cell.percentiles(quantity, percentiles, values.subspan(means ? 2 : 1));
    for (double& value : values) value /= per;
  };
  return group;
}

MapGroup of_all(PlainGroup plain) {
  return {std::move(plain.kinds),
          [values = std::move(plain.values)](const MapCellTallies& cell, std::span<double> out) {
            values(cell.all, cell.rocks, out);
          }};
}

/// The name with a word before the unit.
std::string with_word(const MapKind& kind, const MapSubjectRow& row, std::string_view word) {
  if (row.unit_in_name.empty()) return fmt::format("{}_{}", kind.name, word);
  const std::string_view before(kind.name.data(), kind.name.size() - row.unit_in_name.size());
  return fmt::format("{}{}_{}", before, word, row.unit_in_name);
}

MapGroup bands_of(PlainGroup plain, const MapSubjectRow& row) {
  MapGroup group{.needs_ensembles = true};
  for (const MapKind& kind : plain.kinds) {
    for (const MapBandEnd& end : map_band_ends) {
      MapKind& band = group.kinds.emplace_back(kind);
      band.name = with_word(kind, row, end.word);
      band.meaning = fmt::format("{}; {}", kind.meaning, end.meaning);
    }
  }
  const std::size_t count = plain.kinds.size();
  group.values = [count, values = std::move(plain.values)](const MapCellTallies& cell, std::span<double> out) {
    band_values(cell, values, count, out);
  };
  return group;
}

MapGroup bands_of_reach() {
  const MapSubjects reach = only(MapCount::reach_share);
  const auto row = std::ranges::find(map_subjects, MapCount::reach_share, &MapSubjectRow::count);
  MapGroup group = bands_of(counts_of(reach), *row);
  group.kinds.push_back({.name = fmt::format("{}_parameter_part", row->name),
                         .meaning = "part of the parameters in its variance between ensembles",
                         .limits = {0.1, 0.3, 0.5, 0.7, 0.9},
                         .overview = MapOverview::mean});
  group.values = [ends = std::move(group.values)](const MapCellTallies& cell, std::span<double> out) {
    ends(cell, out.first(map_band_ends.size()));
    out[map_band_ends.size()] = parameter_part_of_reach(cell);
  };
  return group;
}

MapContents contents_for(const MapSubjects& subjects, const MapSelection& selection) {
  MapContents::Choice gathered{}, with_percentiles{};
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    if (!map_subjects[k].quantity || !subjects[k]) continue;
    const auto place = static_cast<std::size_t>(*map_subjects[k].quantity);
    gathered[place] = true;
    with_percentiles[place] = !selection.percentiles.empty();
  }
  return {gathered, with_percentiles, selection.means};
}

}  // namespace

MapContents contents_of(const MapSelection& selection) { return contents_for(selection.subjects, selection); }

MapContents contents_of_ensembles(const MapSelection& selection) { return contents_for(selection.bands, selection); }

std::vector<MapGroup> map_groups(const MapSelection& selection) {
  std::vector<MapGroup> groups;
  if (PlainGroup group = counts_of(selection.subjects); !group.kinds.empty())
    groups.push_back(of_all(std::move(group)));
  if ((selection.bands & only(MapCount::reach_share)).any()) groups.push_back(bands_of_reach());
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    const MapSubjectRow& row = map_subjects[k];
    if (!row.quantity || !selection.subjects[k]) continue;
    groups.push_back(of_all(group_of(row, selection)));
    if (selection.bands[k]) groups.push_back(bands_of(group_of(row, selection), row));
  }
  return groups;
}

std::vector<MapKind> map_families() {
  std::vector<MapKind> kinds;
  for (const MapSubjectRow& row : map_subjects) {
    kinds.push_back(row.count ? kind_of_count(row)
                              : kind_of_quantity(row, "…", "`max`, `mean` and the percentiles", MapOverview::maximum));
  }
  for (const MapBandEnd& end : map_band_ends)
    kinds.push_back(
        {.name = fmt::format("…_{}", end.word),
         .meaning = fmt::format("of the `reach_share`s and quantities of `output.bands`: {}", end.meaning)});
  kinds.push_back({.name = "reach_share_parameter_part",
                   .meaning = "part of the parameters in the variance of the `reach_share` between ensembles"});
  return kinds;
}

std::vector<SectionFigure> section_figures() {
  std::vector<SectionFigure> quantities, shares, counts;
  for (const MapSubjectRow& row : map_subjects) {
    if (row.quantity) {
      quantities.push_back({row.name, row.title, row.unit});
    } else if (is_share(row)) {
      shares.push_back({row.name, row.title, "%", 0.01});
    } else {
      counts.push_back({row.name, row.title});
    }
  }
  std::vector<SectionFigure> all = std::move(quantities);
  all.insert(all.end(), shares.begin(), shares.end());
  all.insert(all.end(), counts.begin(), counts.end());
  return all;
}

std::vector<MapKind> map_kinds(const MapSelection& selection) {
  std::vector<MapKind> kinds;
  for (const MapGroup& group : map_groups(selection)) kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
  return kinds;
}

}  // namespace talus
