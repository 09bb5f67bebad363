#include "talus/io/map_style.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace talus::io {

namespace {

// "YlOrRd" of C. Brewer's ColorBrewer 2.0: one hue deeper and deeper, told apart in print and by the colour-blind.
constexpr std::array<std::string_view, 7> colours{"#ffffb2", "#fed976", "#feb24c", "#fd8d3c",
                                                  "#fc4e2a", "#e31a1c", "#b10026"};

}  // namespace

std::string qgis_style(ColourScale scale, double least, double greatest) {
  if (scale == ColourScale::linear) least = 0;
  std::string items;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(colours.size() - 1);
    const bool is_logarithmic = scale == ColourScale::logarithmic && least > 0;
    const double value = is_logarithmic ? least * std::pow(greatest / least, part) : least + part * (greatest - least);
    items += fmt::format("     <item value=\"{}\" label=\"{:.3g}\" color=\"{}\" alpha=\"255\"/>\n", value, value,
                         colours[k]);
  }
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
