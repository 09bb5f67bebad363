#include "talus/ground/material.hpp"

#include <algorithm>
#include <functional>

namespace talus {

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

std::optional<FaceTilt> GroundDraw::met_face(const Material& material, std::uint32_t contact, double sin_a,
                                             double cos_a, bool in_section) const {
  const std::uint32_t first = 2 * RoughGround::max_proposals * contact;
  return material.roughness.met_face(sin_a, cos_a, in_section,
                                     [&](std::uint32_t k) { return draws_.pair(Stream::met_face, first + k); });
}

FaceTilt GroundDraw::tilt_at_impact(const Material& material, std::uint32_t contact) const {
  return material.roughness.tilt_at_impact(
      [&](std::uint32_t k) { return draws_.pair(Stream::roughness, 2 * contact + k); });
}

}  // namespace talus
