#pragma once
// What the ground is made of: its random properties, and which facet has which material.

#include <string>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"

namespace talus {

struct Material {
  std::string name;
  Sampler normal_restitution;      // Rn, 0 to 1
  Sampler tangential_restitution;  // Rt, 0 to 1
  Sampler friction_angle;          // phi [rad], lumped mass
  Sampler roughness;               // angle that tilts the local normal [rad]
  double roughness_spacing = 0;    // of points of the ground that stand off the facet [m]; rigid sphere, 0: off
  double roughness_amplitude = 0;  // standard deviation of their heights [m]
  Sampler dynamic_friction;        // mu, rigid sphere
  Sampler rolling_friction;        // mu_r, rigid sphere

  [[nodiscard]] bool is_rough() const { return !roughness.is_constant() || is_bumpy(); }
  [[nodiscard]] bool is_bumpy() const { return roughness_spacing > 0 && roughness_amplitude > 0; }
};

/// Materials and where they are.
class Ground {
 public:
  Ground() = default;
  /// One material everywhere.
  explicit Ground(Material material) : materials_{std::move(material)} {}
  /// `of_facet[i]` is the material of the terrain's i-th segment or triangle, as the terrain's source numbers it.
  Ground(std::vector<Material> materials, std::vector<MaterialId> of_facet)
      : materials_(std::move(materials)), of_facet_(std::move(of_facet)) {}

  [[nodiscard]] MaterialId material_of(std::uint32_t source) const {
    return of_facet_.empty() ? MaterialId{0} : of_facet_[source];
  }
  [[nodiscard]] const Material& operator[](MaterialId id) const { return materials_[id.index]; }
  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }

 private:
  std::vector<Material> materials_;
  std::vector<MaterialId> of_facet_;  // empty: the first material everywhere
};

enum class MaterialSampling { per_impact, per_rock };

/// The properties that one contact draws. Per impact, every contact draws afresh; per rock, a rock finds the same
/// properties wherever it meets the same material.
class GroundDraw {
 public:
  GroundDraw(const Draws& draws, MaterialSampling sampling, MaterialId material, std::uint32_t contact)
      : draws_(draws), index_(sampling == MaterialSampling::per_rock ? 0x80000000U | material.index : contact) {}

  [[nodiscard]] std::array<double, 2> restitution(const Material& material) const;
  [[nodiscard]] double friction_angle(const Material& material) const;
  [[nodiscard]] double dynamic_friction(const Material& material) const;
  [[nodiscard]] double rolling_friction(const Material& material) const;
  /// Two independent angles that tilt the ground, ahead and aside [rad]. The ground's shape is drawn afresh at every
  /// contact: `contact` tells them apart.
  [[nodiscard]] std::array<double, 2> roughness(const Material& material, std::uint32_t contact) const;

 private:
  const Draws& draws_;
  std::uint32_t index_;
};

}  // namespace talus
