#include "talus/io/map_list.hpp"

#include <fmt/format.h>

namespace talus::io {

namespace {

struct Quantity {
  MapQuantity quantity;
  const char* name;
  const char* meaning;
  const char* unit;
  const char* unit_in_name;
  double per;  // the unit, in that of MapQuantity
  ClassLimits limits;
};

constexpr ClassLimits counts{10, 100, 1000, 10'000, 100'000}, shares{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
constexpr ClassLimits energies{30, 100, 300, 1000, 3000};  // [kJ]

constexpr Quantity quantities[] = {
    {MapQuantity::energy_total, "energy_total", "kinetic energy, translational and rotational", "kJ", "kJ", 1000,
     energies},
    {MapQuantity::energy_translational, "energy_translational", "translational kinetic energy", "kJ", "kJ", 1000,
     energies},
    {MapQuantity::velocity, "velocity", "velocity", "m/s", "m_s", 1, {5, 10, 15, 20, 30}},
    {MapQuantity::bounce_height,
     "bounce_height",
     "height of the centre above the ground below it",
     "m",
     "m",
     1,
     {0.5, 1, 2, 5, 10}},
};

MapGroup counts_of(std::uint64_t rocks) {
  return {{{"passages", "rocks that were in the cell", "", counts, true, MapOverview::greatest},
           {"reach_share", "share of all rocks that were in the cell", "", shares, false, MapOverview::greatest},
           {"deposits", "rocks that came to rest in the cell", "", counts, true, MapOverview::greatest},
           {"impacts", "impacts on the ground of the cell", "", counts, true, MapOverview::greatest}},
          [rocks](const MapTally& cell, std::span<double> values) {
            values[0] = static_cast<double>(cell.passages());
            values[1] = values[0] / static_cast<double>(rocks);
            values[2] = static_cast<double>(cell.deposits());
            values[3] = static_cast<double>(cell.impacts());
          }};
}

MapGroup group_of(const Quantity& q, std::vector<double> percentiles) {
  MapGroup group;
  const auto add = [&](const std::string& part, const std::string& meaning, MapOverview overview) {
    group.kinds.push_back({fmt::format("{}_{}_{}", q.name, part, q.unit_in_name),
                           fmt::format("{}: {}", q.meaning, meaning), q.unit, q.limits, false, overview});
  };
  add("max", "greatest of all rocks", MapOverview::greatest);
  add("mean", "mean over the rocks", MapOverview::mean);
  for (const double percent : percentiles) {
    add(fmt::format("p{}", percent), fmt::format("percentile {} of the rocks", percent), MapOverview::greatest);
  }
  group.values = [quantity = q.quantity, per = q.per, percentiles = std::move(percentiles)](const MapTally& cell,
                                                                                            std::span<double> values) {
    values[0] = cell.maximum(quantity);
    values[1] = cell.mean(quantity);
    if (!percentiles.empty()) cell.percentiles(quantity, percentiles, values.subspan(2));
    for (double& value : values) value /= per;
  };
  return group;
}

}  // namespace

std::vector<MapGroup> map_groups(std::uint64_t rocks, std::span<const double> percentiles,
                                 const MapContents& contents) {
  std::vector<MapGroup> groups{counts_of(rocks)};
  for (const Quantity& q : quantities) {
    if (!contents.place(q.quantity)) continue;
    const bool has_percentiles = contents.place_of_percentiles(q.quantity).has_value();
    groups.push_back(group_of(
        q, has_percentiles ? std::vector<double>(percentiles.begin(), percentiles.end()) : std::vector<double>()));
  }
  return groups;
}

std::vector<MapKind> map_kinds(std::span<const double> percentiles) {
  std::vector<MapKind> kinds;
  for (const MapGroup& group : map_groups(1, percentiles))
    kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
  return kinds;
}

}  // namespace talus::io
