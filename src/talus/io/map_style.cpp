#include "talus/io/map_style.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace talus::io {

namespace {

// "YlOrRd" of C. Brewer's ColorBrewer 2.0: one hue deeper and deeper, told apart in print and by the colour-blind.
constexpr std::array<std::array<std::uint8_t, 3>, 7> colours{{{0xff, 0xff, 0xb2},
                                                              {0xfe, 0xd9, 0x76},
                                                              {0xfe, 0xb2, 0x4c},
                                                              {0xfd, 0x8d, 0x3c},
                                                              {0xfc, 0x4e, 0x2a},
                                                              {0xe3, 0x1a, 0x1c},
                                                              {0xb1, 0x00, 0x26}}};

double first_of(ColourScale scale, const ColourRange& range) { return scale == ColourScale::linear ? 0 : range.least; }

std::string label_of_top(const ColourRange& range) {
  if (!range.is_open_upwards()) return fmt::format("{:.3g}", range.top);
  return fmt::format("{:.3g} or more, at most {:.3g}", range.top, range.greatest);
}

}  // namespace

std::vector<ColourStop> colour_ramp(ColourScale scale, const ColourRange& range) {
  const double least = first_of(scale, range);
  const bool is_logarithmic = scale == ColourScale::logarithmic && least > 0;
  std::vector<ColourStop> stops;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(colours.size() - 1);
    const double value =
        is_logarithmic ? least * std::pow(range.top / least, part) : least + part * (range.top - least);
    stops.push_back({value, colours[k]});
  }
  return stops;
}

std::string qgis_style(ColourScale scale, const ColourRange& range) {
  const std::vector<ColourStop> ramp = colour_ramp(scale, range);
  std::string items;
  for (std::size_t k = 0; k < ramp.size(); ++k) {
    const auto& [value, colour] = ramp[k];
    const std::string label = k + 1 < ramp.size() ? fmt::format("{:.3g}", value) : label_of_top(range);
    items += fmt::format("     <item value=\"{}\" label=\"{}\" color=\"#{:02x}{:02x}{:02x}\" alpha=\"255\"/>\n", value,
                         label, colour[0], colour[1], colour[2]);
  }
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      "<qgis version=\"3.22\" styleCategories=\"Symbology\">\n"
      " <pipe>\n"
      "  <rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"0.8\" alphaBand=\"-1\" nodataColor=\"\"\n"
      "    classificationMin=\"{0}\" classificationMax=\"{1}\" greatestValue=\"{2}\">\n"
      "   <rasterTransparency/>\n"
      "   <rastershader>\n"
      "    <colorrampshader colorRampType=\"INTERPOLATED\" classificationMode=\"1\" clip=\"0\"\n"
      "      minimumValue=\"{0}\" maximumValue=\"{1}\">\n"
      "{3}"
      "     <rampLegendSettings minimumLabel=\"\" maximumLabel=\"{4}\" prefix=\"\" suffix=\"\" direction=\"0\"\n"
      "       orientation=\"2\" useContinuousLegend=\"1\"/>\n"
      "    </colorrampshader>\n"
      "   </rastershader>\n"
      "  </rasterrenderer>\n"
      "  <brightnesscontrast/>\n"
      "  <huesaturation/>\n"
      "  <rasterresampler/>\n"
      " </pipe>\n"
      " <blendMode>0</blendMode>\n"
      "</qgis>\n",
      first_of(scale, range), range.top, range.greatest, items, range.is_open_upwards() ? label_of_top(range) : "");
}

}  // namespace talus::io
