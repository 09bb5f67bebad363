#pragma once
// A mesh from outside made fit to simulate rocks on: vertices at one place are one, facets have area and are there
// once, each knows its neighbours, and all face out of the ground.

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

/// A facet whose height (twice its area over its longest edge) is less has no usable normal and is left out [m]. Where
/// coordinates are so large that 64-bit numbers are coarser, eight units in the last place of the largest one count.
inline constexpr double smallest_facet_height_m = 1e-9;

/// A facet is vertical when its unit normal's z is this close to 0 (0.2 seconds of arc): what rounding of coordinates
/// of 2.6 million metres makes of a vertical wall a metre wide is a thousand times less.
inline constexpr double vertical_n_z = 1e-6;

/// Coordinates must be smaller [m]: beyond, 64-bit numbers are coarser than a tenth of a micrometre. Any projected
/// coordinate system on Earth is far inside.
inline constexpr double largest_coordinate_m = 1e9;

/// The facet on the other side of an edge, or none: like std::optional<FacetId>, in four bytes.
class Neighbour {
 public:
  constexpr Neighbour() = default;
  constexpr explicit Neighbour(FacetId facet) : index_(facet.index) {}
  [[nodiscard]] constexpr bool has_value() const { return index_ != none; }
  [[nodiscard]] constexpr explicit operator bool() const { return has_value(); }
  [[nodiscard]] constexpr FacetId operator*() const {
    TALUS_PROMISE(has_value(), "asked only for a neighbour that is there");
    return FacetId{index_};
  }
  friend constexpr bool operator==(Neighbour, Neighbour) = default;

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t index_ = none;
};

struct CleaningOptions {
  std::string source;           // the file as the user named it, for messages
  double weld_tolerance_m = 0;  // vertices as near as this become one; 0: only equal ones
};

/// Every index exists, no triangle has a corner twice, no two have the same three corners.
struct CleanMesh {
  std::vector<Vec3> vertices;                           // global coordinates [m], in the order of the raw mesh
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside the ground
  std::vector<std::array<Neighbour, 3>> neighbours;     // edge k joins corners k and k+1
  std::vector<std::uint32_t> original;                  // number in the raw mesh of each triangle; ascending
  CleaningReport report;
};

/// Cleans in O(n log n). A component (what hangs together across edges of exactly two facets) gets one winding: if it
/// is open, the one with which most of its area in plan faces up, so that an overhang faces down and a bowl up; if it
/// is closed, the one that faces out of the solid. Sides of the ground that are joined by a non-manifold edge only are
/// thus turned each for itself. Facets left out leave a gap no wider than smallest_facet_height_m. Throws BadInput when
/// an index or a coordinate is not usable, or when nothing is left.
[[nodiscard]] CleanMesh clean(RawMesh mesh, const CleaningOptions& options = {});

}  // namespace talus
