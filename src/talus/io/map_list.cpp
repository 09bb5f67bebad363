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
  ColourScale scale;
};

constexpr Quantity quantities[] = {
    {MapQuantity::energy_total, "energy_total", "kinetic energy, translational and rotational", "J", "J",
     ColourScale::logarithmic},
    {MapQuantity::energy_translational, "energy_translational", "translational kinetic energy", "J", "J",
     ColourScale::logarithmic},
    {MapQuantity::velocity, "velocity", "velocity", "m/s", "m_s", ColourScale::linear},
    {MapQuantity::bounce_height, "bounce_height", "height of the centre above the ground below it", "m", "m",
     ColourScale::linear},
};

}  // namespace

std::vector<MapKind> map_kinds(std::uint64_t rocks, std::span<const double> percentiles) {
  constexpr auto logarithmic = ColourScale::logarithmic;
  std::vector<MapKind> kinds{
      {"passages", "rocks that were in the cell", "", logarithmic, true, MapOverview::greatest,
       [](const MapTally& cell) { return static_cast<double>(cell.passages()); }},
      {"reach_share", "share of all rocks that were in the cell", "", logarithmic, false, MapOverview::greatest,
       [rocks](const MapTally& cell) { return static_cast<double>(cell.passages()) / static_cast<double>(rocks); }},
      {"deposits", "rocks that came to rest in the cell", "", logarithmic, true, MapOverview::greatest,
       [](const MapTally& cell) { return static_cast<double>(cell.deposits()); }},
      {"impacts", "impacts on the ground of the cell", "", logarithmic, true, MapOverview::greatest,
       [](const MapTally& cell) { return static_cast<double>(cell.impacts()); }}};
  for (const Quantity& q : quantities) {
    const auto add = [&](const std::string& part, const std::string& meaning, MapOverview overview,
                         std::function<double(const MapTally&)> f) {
      kinds.push_back({fmt::format("{}_{}_{}", q.name, part, q.unit_in_name), fmt::format("{}: {}", q.meaning, meaning),
                       q.unit, q.scale, false, overview, std::move(f)});
    };
    const MapQuantity quantity = q.quantity;
    add("max", "greatest of all rocks", MapOverview::greatest,
        [quantity](const MapTally& cell) { return cell.maximum(quantity); });
    add("mean", "mean over the rocks", MapOverview::mean,
        [quantity](const MapTally& cell) { return cell.mean(quantity); });
    for (const double percent : percentiles) {
      add(fmt::format("p{}", percent), fmt::format("percentile {} of the rocks", percent), MapOverview::greatest,
          [quantity, percent](const MapTally& cell) { return cell.percentile(quantity, percent); });
    }
  }
  return kinds;
}

}  // namespace talus::io
