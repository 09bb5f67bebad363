// The colours of map classes, as readers with each kind of colour vision see them.

#include "talus/maps/map_style.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace talus {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
  Triple out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = m[k][0] * v[0] + m[k][1] * v[1] + m[k][2] * v[2];
  return out;
}

struct Vision {
  std::string name;
  Matrix of_linear_rgb;
};

/// Without one kind of cone: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A physiologically-based model for
/// simulation of color vision deficiency", IEEE Transactions on Visualization and Computer Graphics 15 (2009)
/// 1291-1298, severity 1. Grey: as printed without colour.
const std::array<Vision, 5> visions{{
    {"all cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
    {"grey", {{{0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}}}},
}};

/// CIELAB (D65) of a colour of sRGB as this vision sees it.
Triple seen(const std::array<std::uint8_t, 3>& colour, const Vision& vision) {
  Triple linear{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = colour[k] / 255.0;
    linear[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  linear = times(vision.of_linear_rgb, linear);
  for (double& part : linear) part = std::clamp(part, 0.0, 1.0);
  constexpr Matrix to_xyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  constexpr Triple white{0.9505, 1, 1.089};
  Triple f = times(to_xyz, linear);
  for (std::size_t k = 0; k < 3; ++k) {
    const double share = f[k] / white[k];
    f[k] = share > 216.0 / 24389 ? std::cbrt(share) : (24389.0 / 27 * share + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double difference(const Triple& one, const Triple& other) {
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

/// A difference of 2.3 in CIELAB is just noticeable side by side; classes are told apart in a legend with four times as
/// much. Each class is darker than the one below, so that their order can be seen as well.
TEST(MapColours, AreToldApartWithAnyColourVision) {
  const auto classes = map_classes({1, 2, 3, 4, 5});
  for (const Vision& vision : visions) {
    SCOPED_TRACE(vision.name);
    for (std::size_t k = 0; k + 1 < classes.size(); ++k) {
      const Triple lower = seen(classes[k].colour, vision), higher = seen(classes[k + 1].colour, vision);
      EXPECT_GT(lower[0] - higher[0], 4) << "classes " << k << " and " << k + 1;
      for (std::size_t other = k + 1; other < classes.size(); ++other)
        EXPECT_GT(difference(lower, seen(classes[other].colour, vision)), 9.2) << "classes " << k << ", " << other;
    }
  }
}

}  // namespace
}  // namespace talus
