#include "talus/ground/material.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <functional>
#include <numbers>

namespace talus {

namespace {

// A standard normal number from a uniform one.
double standard_normal(double u) { return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * u); }

}  // namespace

Ground::Ground(std::vector<Material> materials, std::vector<std::uint8_t> of_cell) : materials_(std::move(materials)) {
  const bool varies = std::adjacent_find(of_cell.begin(), of_cell.end(), std::not_equal_to<>()) != of_cell.end();
  if (varies) {
    cells_ = std::move(of_cell);
    of_cell_ = cells_->data();
  } else if (!of_cell.empty()) {
    everywhere_ = MaterialId{of_cell.front()};
  }
}

std::array<double, 2> GroundDraw::restitution(const Material& material) const {
  const Sampler &rn = material.normal_restitution, &rt = material.tangential_restitution;
  if (rn.is_constant() && rt.is_constant()) return {rn.draw(0.5), rt.draw(0.5)};
  const auto u = draws_.pair(Stream::restitution, index_);
  return {rn.draw(u[0]), rt.draw(u[1])};
}

double GroundDraw::friction_angle(const Material& material) const {
  const Sampler& phi = material.friction_angle;
  return phi.is_constant() ? phi.draw(0.5) : phi.draw(draws_.pair(Stream::friction, index_)[0]);
}

double GroundDraw::dynamic_friction(const Material& material) const {
  const Sampler& mu = material.dynamic_friction;
  return mu.is_constant() ? mu.draw(0.5) : mu.draw(draws_.pair(Stream::friction, index_)[1]);
}

double GroundDraw::rolling_friction(const Material& material) const {
  const Sampler& mu = material.rolling_friction;
  return mu.is_constant() ? mu.draw(0.5) : mu.draw(draws_.one(Stream::rolling_friction, index_));
}

std::array<double, 2> GroundDraw::roughness(const Material& material, std::uint32_t contact) const {
  const auto u = draws_.pair(Stream::roughness, 2 * contact);
  std::array<double, 2> tilt{0, 0};
  if (!material.roughness.is_constant()) {
    // Ahead, the mean angle may be positive or negative; aside, both sides are equally likely.
    const bool is_left = u[1] < 0.5;
    const double aside = std::clamp(is_left ? 2 * u[1] : 2 * u[1] - 1, 0x1p-53, 1 - 0x1p-53);
    tilt = {material.roughness.draw(u[0]), (is_left ? -1 : 1) * material.roughness.draw(aside)};
  }
  if (material.is_bumpy()) {
    // The difference of two independent heights, sqrt(2) amplitudes wide.
    const auto heights = draws_.pair(Stream::roughness, 2 * contact + 1);
    for (std::size_t k = 0; k < 2; ++k) {
      const double rise = std::numbers::sqrt2 * material.roughness_amplitude * standard_normal(heights[k]);
      tilt[k] += std::atan(rise / material.roughness_spacing);
    }
  }
  return tilt;
}

}  // namespace talus
