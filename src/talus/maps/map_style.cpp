#include "talus/maps/map_style.hpp"

#include <fmt/format.h>

#include <cmath>

namespace talus {

namespace {

// After "YlOrRd" of C. Brewer's ColorBrewer 2.0, with more even steps of lightness: its third and fourth of six colours
// are hard to tell apart without green cones and in print without colour (test/maps/map_style_test.cpp).
constexpr std::array<std::array<std::uint8_t, 3>, map_class_count> colours{{{0xff, 0xff, 0xb2},
                                                                            {0xfe, 0xd6, 0x70},
                                                                            {0xfd, 0xa6, 0x3f},
                                                                            {0xf0, 0x70, 0x2c},
                                                                            {0xc8, 0x28, 0x1e},
                                                                            {0x80, 0x00, 0x26}}};

std::string label_of(const MapClass& each, const MapUnit& unit) {
  const std::string behind = unit.text.empty() ? "" : fmt::format(" {}", unit.text);
  if (std::isinf(each.to)) return fmt::format("{:g}{} and more", each.from / unit.per, behind);
  return fmt::format("{:g} to {:g}{}", each.from / unit.per, each.to / unit.per, behind);
}

}  // namespace

std::array<MapClass, map_class_count> map_classes(const ClassLimits& limits) {
  std::array<MapClass, map_class_count> classes;
  for (std::size_t k = 0; k < map_class_count; ++k) {
    classes[k].colour = colours[k];
    if (k > 0) classes[k].from = limits[k - 1];
    if (k < limits.size()) classes[k].to = limits[k];
  }
  return classes;
}

std::string qgis_style(const ClassLimits& limits, const MapUnit& unit, const ValueRange& range) {
  std::string items;
  for (const MapClass& each : map_classes(limits)) {
    // QGIS assigns the limit itself to the class below it: values with a fraction are never exactly on it.
    const std::string end = std::isinf(each.to) ? "inf" : fmt::format("{}", each.to);
    items += fmt::format("     <item value=\"{}\" label=\"{}\" color=\"#{:02x}{:02x}{:02x}\" alpha=\"255\"/>\n", end,
                         label_of(each, unit), each.colour[0], each.colour[1], each.colour[2]);
  }
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      "<qgis version=\"3.22\" styleCategories=\"Symbology\">\n"
      " <pipe>\n"
      "  <rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"0.8\" alphaBand=\"-1\" nodataColor=\"\"\n"
      "    classificationMin=\"0\" classificationMax=\"inf\" leastValue=\"{0}\" greatestValue=\"{1}\">\n"
      "   <rasterTransparency/>\n"
      "   <rastershader>\n"
      "    <colorrampshader colorRampType=\"DISCRETE\" classificationMode=\"1\" clip=\"0\"\n"
      "      minimumValue=\"0\" maximumValue=\"inf\">\n"
      "{2}"
      "    </colorrampshader>\n"
      "   </rastershader>\n"
      "  </rasterrenderer>\n"
      "  <brightnesscontrast/>\n"
      "  <huesaturation/>\n"
      "  <rasterresampler/>\n"
      " </pipe>\n"
      " <blendMode>0</blendMode>\n"
      "</qgis>\n",
      range.least, range.greatest, items);
}

}  // namespace talus
