#include "talus/maps/map_list.hpp"

#include <fmt/format.h>

#include <utility>

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

MapGroup counts_of(std::uint64_t rocks, const MapSubjects& subjects) {
  MapGroup group;
  std::vector<MapCount> chosen;
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    const MapSubjectRow& row = map_subjects[k];
    if (!row.count || !subjects[k]) continue;
    chosen.push_back(*row.count);
    group.kinds.push_back(kind_of_count(row));
  }
  group.values = [rocks, chosen = std::move(chosen)](const MapTally& cell, std::span<double> values) {
    for (std::size_t k = 0; k < chosen.size(); ++k) values[k] = value_of(chosen[k], cell, static_cast<double>(rocks));
  };
  return group;
}

MapGroup group_of(const MapSubjectRow& row, const std::vector<double>& percentiles) {
  MapGroup group;
  const auto add = [&](const std::string& part, const std::string& meaning, MapOverview overview) {
    group.kinds.push_back(kind_of_quantity(row, part, meaning, overview));
  };
  add("max", "maximum over all rocks", MapOverview::maximum);
  add("mean", "mean over the rocks", MapOverview::mean);
  for (const double percent : percentiles) {
    add(fmt::format("p{}", percent), fmt::format("percentile {} of the rocks", percent), MapOverview::maximum);
  }
  group.values = [quantity = *row.quantity, per = row.per, percentiles](const MapTally& cell,
                                                                        std::span<double> values) {
    values[0] = cell.maximum(quantity);
    values[1] = cell.mean(quantity);
    if (!percentiles.empty()) cell.percentiles(quantity, percentiles, values.subspan(2));
    for (double& value : values) value /= per;
  };
  return group;
}

}  // namespace

MapContents contents_of(const MapSelection& selection) {
  MapContents::Choice gathered{}, with_percentiles{};
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    if (!map_subjects[k].quantity || !selection.subjects[k]) continue;
    const auto place = static_cast<std::size_t>(*map_subjects[k].quantity);
    gathered[place] = true;
    with_percentiles[place] = !selection.percentiles.empty();
  }
  return {gathered, with_percentiles};
}

std::vector<MapGroup> map_groups(std::uint64_t rocks, const MapSelection& selection) {
  std::vector<MapGroup> groups;
  if (MapGroup group = counts_of(rocks, selection.subjects); !group.kinds.empty()) groups.push_back(std::move(group));
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    const MapSubjectRow& row = map_subjects[k];
    if (row.quantity && selection.subjects[k]) groups.push_back(group_of(row, selection.percentiles));
  }
  return groups;
}

std::vector<MapKind> map_families() {
  std::vector<MapKind> kinds;
  for (const MapSubjectRow& row : map_subjects) {
    kinds.push_back(row.count ? kind_of_count(row)
                              : kind_of_quantity(row, "…", "`max`, `mean` and the percentiles", MapOverview::maximum));
  }
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
  for (const MapGroup& group : map_groups(1, selection))
    kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
  return kinds;
}

}  // namespace talus
