#include "talus/import/survey_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

#include "talus/files/mesh_problems.hpp"
#include "talus/import/filler_values.hpp"
#include "talus/import/mesh_text.hpp"
#include "talus/import/raster_file.hpp"

namespace talus {

bool FeatureHeights::assign(VectorFeature& feature) {
  const std::string name = fmt::format("feature {}", feature.id);
  std::optional<double> height;
  if (!attribute_.empty()) {
    const auto& value = feature.values.front();
    if (!value) return refuse(name + " has no height", fmt::format("its {} is empty", attribute_));
    double number = 0;
    const char *begin = value->data(), *end = begin + value->size();
    const auto [rest, error] = std::from_chars(begin, end, number);
    if (error != std::errc{} || rest != end || !std::isfinite(number)) {
      return refuse(fmt::format("{} has the {} {}", name, attribute_, in_quotes(*value)),
                    "a height is a number of metres");
    }
    if (number < lowest_elevation_m || number > highest_elevation_m) {
      return refuse(fmt::format("{} has the height {:.10g}", name, number),
                    fmt::format("heights must be between {:g} and {:g} m", lowest_elevation_m, highest_elevation_m));
    }
    height = number;
  } else if (!feature.has_z && may_lack_) {
    return true;
  } else if (!feature.has_z) {
    return refuse(name + " has no heights", "its geometry has only x and y",
                  "Name the attribute with the heights: elevation_attribute = \"...\"");
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (VectorShape& part : feature.parts) {
    for (auto& list : part.lists) {
      for (Vec3& p : list) {
        if (height) p.z() = *height;
        low = std::min(low, p.z());
        high = std::max(high, p.z());
      }
    }
  }
  if (low == high && may_be_filler(low)) {
    Level& level = fillers_[low];
    if (++level.features == 1) level.first = name;
  } else {
    low_ = std::min(low_, low);
    high_ = std::max(high_, high);
  }
  return true;
}

void FeatureHeights::finish(bool others_have_heights, const std::string& layer_key, Problems& warnings) {
  problems_.throw_if_any();
  if (low_ > high_) {  // without others they are the heights
    for (const auto& [height, level] : fillers_) {
      if (height == 0) continue;
      low_ = std::min(low_, height);
      high_ = std::max(high_, height);
    }
  }
  if (low_ <= high_ || fillers_.empty()) return warn_of_some(layer_key, warnings);
  Problem flat{.file = file_.string(),
               .what = "has only heights of 0",
               .why = "every vertex is at 0",
               .hint = "If an attribute has the heights, name it: elevation_attribute = \"...\""};
  if (!others_have_heights) throw BadInput(flat);
  flat.severity = Severity::warning;
  warnings.add(flat);
}

// A frame at 0 may be part of a drawing; other fillers must be far away.
void FeatureHeights::warn_of_some(const std::string& layer_key, Problems& warnings) const {
  for (const auto& [height, level] : fillers_) {
    const bool is_among_others = low_ <= height && high_ >= height;
    if (is_among_others || (height != 0 && !is_far_from(height, low_, high_))) continue;
    Problem some{
        .file = file_.string(),
        .what = fmt::format("{} at the height {:.10g}",
                            level.features == 1 ? "1 feature lies" : fmt::format("{} features lie", level.features),
                            height),
        .why = fmt::format("the others lie from {:.10g} to {:.10g} m; {} is the first", low_, high_, level.first),
        .hint = height == 0
                    ? fmt::format("To leave out a frame or plan next to the ground, name the ground's layer: {} = "
                                  "\"...\"",
                                  layer_key)
                    : "If it stands for a missing height, remove them"};
    some.severity = Severity::warning;
    warnings.add(some);
  }
}

bool FeatureHeights::refuse(std::string what, std::string why, std::string hint) {
  problems_.add(0, std::move(what), std::move(why), std::move(hint));
  return false;
}

bool names_feet(std::string_view attribute) {
  const std::string name = lower(attribute);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  const auto end = std::find_if(name.rbegin(), name.rend(), is_letter).base();
  const auto begin = std::find_if_not(std::make_reverse_iterator(end), name.rend(), is_letter).base();
  static constexpr std::array<std::string_view, 5> feet{"ft", "feet", "foot", "usft", "ftus"};
  return std::find(feet.begin(), feet.end(), std::string_view(begin, end)) != feet.end();
}

}  // namespace talus
