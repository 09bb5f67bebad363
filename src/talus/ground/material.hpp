#pragma once
// The materials of the ground with their random properties, and the material of each facet.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/shared.hpp"
#include "talus/ground/rough_ground.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"

namespace talus {

/// Friction under a rock with a shape that rises with the way s it has slid [m]: from mu, that of dynamic_friction, to
/// mu + 2/pi (most - mu) atan(rise s). On the ground s grows with the way of the rock's centre; in the air it fades as
/// exp(-decay t). Source: R. Leine et al. (2014), doi 10.1007/s11044-013-9393-4, equations 46 and 47, where s stands
/// for the soil that a rock piles up before it.
struct FrictionRise {
  double most = 0;   // mu_max
  double rise = 0;   // kappa [1/m]; 0: friction does not depend on s
  double decay = 0;  // beta [1/s]

  [[nodiscard]] double friction(double mu, double slid) const {
    if (rise == 0) return mu;
    return mu + 2 / std::numbers::pi * std::max(most - mu, 0.0) * std::atan(rise * slid);
  }
};

/// A forest that is laid over the ground, and what lies below it.
struct LaidForest {
  std::uint32_t material;  // the number of the same ground without it
  std::uint32_t forest;    // its number in the project
};

struct Material {
  std::string name;
  Sampler normal_restitution;             // Rn, 0 to 1
  Sampler tangential_restitution;         // Rt, 0 to 1
  Sampler friction_angle;                 // phi [rad], lumped mass
  RoughGround roughness;                  // the faces that stand on a facet
  Sampler dynamic_friction;               // mu, rigid sphere
  Sampler rolling_friction;               // mu_r, rigid sphere
  double forest_drag = 0;                 // b of the force -b v in its forest [kg/s]; 0: no forest
  double forest_height = 0;               // height above the ground below which the forest brakes [m]
  double ground_drag = 0;                 // drag on a sliding or rolling rock, over mass and velocity [1/s]
  FrictionRise friction_rise;             // rocks with a shape
  std::optional<LaidForest> laid_forest;  // the forest is not the material's own

  [[nodiscard]] bool has_forest() const { return forest_drag > 0 && forest_height > 0; }
  /// The material whose ground it is: another one below a laid forest. `own` is its number.
  [[nodiscard]] MaterialId ground_of(MaterialId own) const {
    return laid_forest ? MaterialId{laid_forest->material} : own;
  }
};

/// The materials, and where they are.
class Ground {
 public:
  Ground() = default;
  /// One material everywhere.
  explicit Ground(Material material) : materials_{std::move(material)} {}
  /// `of_facet[i]` is the material of the terrain's segment or triangle i, as numbered by its source().
  Ground(std::vector<Material> materials, std::vector<MaterialId> of_facet)
      : materials_(std::move(materials)), facets_(std::move(of_facet)) {}
  /// One of several materials everywhere.
  Ground(std::vector<Material> materials, MaterialId everywhere)
      : materials_(std::move(materials)), everywhere_(everywhere) {}
  /// For rasters, a byte per cell: `of_cell[i]` is the material of the terrain's cell i. Not stored if all cells have
  /// the same material.
  Ground(std::vector<Material> materials, std::vector<std::uint8_t> of_cell);

  [[nodiscard]] MaterialId material_of(std::uint32_t source) const {
    if (of_cell_ != nullptr) return MaterialId{of_cell_[source]};
    return of_facet_ == nullptr ? everywhere_ : of_facet_[source];
  }
  [[nodiscard]] const Material& operator[](MaterialId id) const { return materials_[id.index]; }
  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }
  /// Replaces the properties of all materials; where they are does not change. Expects as many as there are.
  void set_materials(std::vector<Material> materials) { materials_ = std::move(materials); }
  [[nodiscard]] bool is_rough() const {
    return std::any_of(materials_.begin(), materials_.end(),
                       [](const Material& m) { return !m.roughness.is_smooth(); });
  }
  [[nodiscard]] bool has_forest() const {
    return std::any_of(materials_.begin(), materials_.end(), [](const Material& m) { return m.has_forest(); });
  }
  /// Memory that grows with the terrain; copies share it.
  [[nodiscard]] std::size_t bytes() const { return facets_->size() * sizeof(MaterialId) + cells_->size(); }

 private:
  std::vector<Material> materials_;
  // At most one of these has entries; if none has, `everywhere_` is the material. The pointers, null without entries,
  // save a step where a rock strikes.
  Shared<std::vector<MaterialId>> facets_;
  Shared<std::vector<std::uint8_t>> cells_;
  const MaterialId* of_facet_ = facets_->empty() ? nullptr : facets_->data();
  const std::uint8_t* of_cell_ = nullptr;
  MaterialId everywhere_{0};
};

enum class MaterialSampling { per_impact, per_rock };

/// Draws the ground's properties for one contact. Per impact, every contact draws new ones; per rock, a rock has the
/// same properties at all contacts with the same material, within a forest that is laid over it and outside.
class GroundDraw {
 public:
  GroundDraw(const Draws& draws, MaterialSampling sampling, MaterialId material, std::uint32_t contact)
      : draws_(draws), index_(sampling == MaterialSampling::per_rock ? 0x80000000U | material.index : contact) {}

  [[nodiscard]] std::array<double, 2> restitution(const Material& material) const;
  [[nodiscard]] double friction_angle(const Material& material) const;
  [[nodiscard]] double dynamic_friction(const Material& material) const;
  [[nodiscard]] double rolling_friction(const Material& material) const;
  // The faces of rough ground are drawn at every contact, numbered `contact`, also with sampling per rock.
  /// RoughGround::met_face.
  [[nodiscard]] std::optional<FaceTilt> met_face(const Material& material, std::uint32_t contact, double sin_a,
                                                 double cos_a, bool in_section) const;
  /// RoughGround::tilt_at_impact.
  [[nodiscard]] FaceTilt tilt_at_impact(const Material& material, std::uint32_t contact) const;

 private:
  const Draws& draws_;
  std::uint32_t index_;
};

}  // namespace talus
