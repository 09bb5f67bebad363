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

}  // namespace

std::vector<ColourStop> colour_ramp(ColourScale scale, double least, double greatest) {
  if (scale == ColourScale::linear) least = 0;
  const bool is_logarithmic = scale == ColourScale::logarithmic && least > 0;
  std::vector<ColourStop> stops;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(colours.size() - 1);
    const double value = is_logarithmic ? least * std::pow(greatest / least, part) : least + part * (greatest - least);
    stops.push_back({value, colours[k]});
  }
  return stops;
}

std::string qgis_style(ColourScale scale, double least, double greatest) {
  std::string items;
  for (const auto& [value, colour] : colour_ramp(scale, least, greatest)) {
    items +=
        fmt::format("     <item value=\"{0}\" label=\"{0:.3g}\" color=\"#{1:02x}{2:02x}{3:02x}\" alpha=\"255\"/>\n",
                    value, colour[0], colour[1], colour[2]);
  }
  if (scale == ColourScale::linear) least = 0;
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      "<qgis version=\"3.22\" styleCategories=\"Symbology\">\n"
      " <pipe>\n"
      "  <rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"0.8\" alphaBand=\"-1\" nodataColor=\"\"\n"
      "    classificationMin=\"{0}\" classificationMax=\"{1}\">\n"
      "   <rasterTransparency/>\n"
      "   <rastershader>\n"
      "    <colorrampshader colorRampType=\"INTERPOLATED\" classificationMode=\"1\" clip=\"0\"\n"
      "      minimumValue=\"{0}\" maximumValue=\"{1}\">\n"
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
      least, greatest, items);
}

}  // namespace talus::io
