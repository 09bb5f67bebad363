#pragma once
// Cleans a mesh from outside so that rocks can be simulated on it: coincident vertices are merged, every facet has an
// area and occurs once, neighbours are found, and all facets face out of the ground.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "talus/core/check.hpp"
#include "talus/core/id.hpp"
#include "talus/meshing/cleaning_report.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

/// A facet lower than this (twice its area over its longest edge) has no usable normal and is left out [m]. Where
/// coordinates are so large that doubles are coarser, the limit is eight units in the last place of the largest one.
inline constexpr double smallest_facet_height_m = 1e-9;

/// A facet is vertical if its unit normal's z is this close to 0 (0.2 seconds of arc). Rounding of coordinates of 2.6
/// million metres tilts a vertical wall a metre wide a thousand times less.
inline constexpr double vertical_n_z = 1e-6;

/// Coordinates must be smaller than this [m]: beyond it, doubles are coarser than a tenth of a micrometre. Any
/// projected coordinate system on Earth stays far below.
inline constexpr double largest_coordinate_m = 1e9;

/// The facet on the other side of an edge, or none: like std::optional<FacetId>, in four bytes.
class Neighbour {
 public:
  constexpr Neighbour() = default;
  constexpr explicit Neighbour(FacetId facet) : index_(facet.index) {}
  [[nodiscard]] constexpr bool has_value() const { return index_ != none; }
  [[nodiscard]] constexpr explicit operator bool() const { return has_value(); }
  [[nodiscard]] constexpr FacetId operator*() const {
    TALUS_PROMISE(has_value(), "only an existing neighbour is dereferenced");
    return FacetId{index_};
  }
  friend constexpr bool operator==(Neighbour, Neighbour) = default;

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t index_ = none;
};

struct CleaningOptions {
  std::string source;           // the file as the user named it, for messages
  double weld_tolerance_m = 0;  // vertices within this distance are merged; 0: only equal ones
};

/// Every index exists, no triangle repeats a corner, and no two triangles have the same three corners.
struct CleanMesh {
  std::vector<Vec3> vertices;                           // global coordinates [m], in the order of the raw mesh
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside the ground
  std::vector<std::array<Neighbour, 3>> neighbours;     // edge k joins corners k and k+1
  std::vector<std::uint32_t> original;                  // each triangle's number in the raw mesh; ascending
  CleaningReport report;
};

/// Cleans in O(n log n). A component (facets connected across edges of exactly two facets) gets one winding: an open
/// one the winding with which most of its plan area faces up, so that an overhang faces down and a bowl up; a closed
/// one the winding that faces out of the solid. Components that share only a non-manifold edge are oriented
/// independently. Dropped facets leave gaps no wider than smallest_facet_height_m. Throws BadInput if an index or a
/// coordinate is unusable, or if no facet remains.
[[nodiscard]] CleanMesh clean(RawMesh mesh, const CleaningOptions& options = {});

}  // namespace talus
