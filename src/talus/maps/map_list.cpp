#include "talus/maps/map_list.hpp"

#include <fmt/format.h>

#include <utility>

namespace talus {

namespace {

constexpr ClassLimits counts{10, 100, 1000, 10'000, 100'000}, shares{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
constexpr ClassLimits energies{30, 100, 300, 1000, 3000};  // [kJ]

struct Count {
  MapSubject subject;
  const char* meaning;
  const ClassLimits& limits;
  bool is_whole;
  double (*value)(const MapTally& cell, double rocks);
};

constexpr Count counted[] = {
    {MapSubject::passages, "rocks that were in the cell", counts, true,
     [](const MapTally& cell, double) { return static_cast<double>(cell.passages()); }},
    {MapSubject::reach_share, "share of all rocks that were in the cell", shares, false,
     [](const MapTally& cell, double rocks) { return static_cast<double>(cell.passages()) / rocks; }},
    {MapSubject::deposits, "rocks that came to rest in the cell", counts, true,
     [](const MapTally& cell, double) { return static_cast<double>(cell.deposits()); }},
    {MapSubject::impacts, "impacts on the ground of the cell", counts, true,
     [](const MapTally& cell, double) { return static_cast<double>(cell.impacts()); }},
};

struct Quantity {
  MapSubject subject;
  MapQuantity quantity;
  const char* meaning;
  const char* unit;
  const char* unit_in_name;
  double per;  // the unit, in that of MapQuantity
  ClassLimits limits;
};

constexpr Quantity quantities[] = {
    {MapSubject::energy_total, MapQuantity::energy_total, "total kinetic energy", "kJ", "kJ", 1000, energies},
    {MapSubject::energy_translational, MapQuantity::energy_translational, "translational kinetic energy", "kJ", "kJ",
     1000, energies},
    {MapSubject::velocity, MapQuantity::velocity, "velocity", "m/s", "m_s", 1, {5, 10, 15, 20, 30}},
    {MapSubject::bounce_height, MapQuantity::bounce_height, "bounce height", "m", "m", 1, {0.5, 1, 2, 5, 10}},
};

MapKind kind_of(const Count& count) {
  return {std::string(name_of(count.subject)), count.meaning, "", count.limits, count.is_whole, MapOverview::greatest};
}

/// `part`: max, mean or a percentile.
MapKind kind_of(const Quantity& q, const std::string& part, const std::string& meaning, MapOverview overview) {
  return {fmt::format("{}_{}_{}", name_of(q.subject), part, q.unit_in_name),
          fmt::format("{}: {}", q.meaning, meaning),
          q.unit,
          q.limits,
          false,
          overview};
}

MapGroup counts_of(std::uint64_t rocks, const MapSubjects& subjects) {
  MapGroup group;
  std::vector<const Count*> chosen;
  for (const Count& count : counted) {
    if (!holds(subjects, count.subject)) continue;
    chosen.push_back(&count);
    group.kinds.push_back(kind_of(count));
  }
  group.values = [rocks, chosen = std::move(chosen)](const MapTally& cell, std::span<double> values) {
    for (std::size_t k = 0; k < chosen.size(); ++k) values[k] = chosen[k]->value(cell, static_cast<double>(rocks));
  };
  return group;
}

MapGroup group_of(const Quantity& q, const std::vector<double>& percentiles) {
  MapGroup group;
  const auto add = [&](const std::string& part, const std::string& meaning, MapOverview overview) {
    group.kinds.push_back(kind_of(q, part, meaning, overview));
  };
  add("max", "greatest of all rocks", MapOverview::greatest);
  add("mean", "mean over the rocks", MapOverview::mean);
  for (const double percent : percentiles) {
    add(fmt::format("p{}", percent), fmt::format("percentile {} of the rocks", percent), MapOverview::greatest);
  }
  group.values = [quantity = q.quantity, per = q.per, percentiles](const MapTally& cell, std::span<double> values) {
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
  for (const Quantity& q : quantities) {
    const auto place = static_cast<std::size_t>(q.quantity);
    gathered[place] = holds(selection.subjects, q.subject);
    with_percentiles[place] = gathered[place] && !selection.percentiles.empty();
  }
  return {gathered, with_percentiles};
}

std::vector<MapGroup> map_groups(std::uint64_t rocks, const MapSelection& selection) {
  std::vector<MapGroup> groups;
  if (MapGroup group = counts_of(rocks, selection.subjects); !group.kinds.empty()) groups.push_back(std::move(group));
  for (const Quantity& q : quantities) {
    if (holds(selection.subjects, q.subject)) groups.push_back(group_of(q, selection.percentiles));
  }
  return groups;
}

std::vector<MapKind> map_families() {
  std::vector<MapKind> kinds;
  for (const Count& count : counted) kinds.push_back(kind_of(count));
  for (const Quantity& q : quantities)
    kinds.push_back(kind_of(q, "…", "`max`, `mean` and the percentiles", MapOverview::greatest));
  return kinds;
}

std::vector<MapKind> map_kinds(const MapSelection& selection) {
  std::vector<MapKind> kinds;
  for (const MapGroup& group : map_groups(1, selection))
    kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
  return kinds;
}

}  // namespace talus
