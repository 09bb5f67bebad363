#pragma once
// What cleaning a mesh found and changed, as text for the user.

#include <cstddef>
#include <string>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/loose_edges.hpp"

namespace talus {

struct CleaningReport {
  std::size_t vertices = 0;         // of the cleaned mesh
  std::size_t facets = 0;           // of the cleaned mesh
  std::size_t welded_vertices = 0;  // merged into another at the same position
  std::size_t unused_vertices = 0;  // left out: no facet uses them
  Findings corners_in_sides;       // corners on sides of other facets, within the tolerance: the sides were split there
  Findings degenerate;             // facets left out: a repeated corner, or no height
  Findings duplicates;             // facets left out: another has the same corners
  Findings flipped;                // facets whose winding was reversed
  Findings non_manifold_edges;     // shared by more than two facets, which get no neighbours there
  std::size_t boundary_edges = 0;  // with one facet only
  LooseEdges loose_edges;          // boundary edges where the ground does not end
  double crack_m = 0;              // the widest gap that counts as a crack
  std::size_t components = 0;      // connected across edges of exactly two facets
  std::size_t closed_components = 0;
  Findings one_sided_components;  // like a Moebius strip: no consistent winding exists
  Findings undecided_components;  // neither plan area nor volume shows which side faces out of the ground
  Findings vertical;              // facets, |n_z| at most vertical_n_z
  Findings overhanging;           // facets, n_z below that

  /// Whether every facet faces up, as in a height field. (Sheets may still lie above each other.)
  [[nodiscard]] bool every_facet_faces_up() const { return vertical.count == 0 && overhanging.count == 0; }
  [[nodiscard]] bool has_warnings() const;
  /// A few lines without a final line feed: first a summary; lines that begin with `warning:` come last.
  [[nodiscard]] std::string text() const;
};

}  // namespace talus
