#pragma once
// What cleaning a mesh found and did, for the user to read.

#include <cstddef>
#include <string>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/loose_edges.hpp"

namespace talus {

struct CleaningReport {
  std::size_t vertices = 0;         // of the cleaned mesh
  std::size_t facets = 0;           // of the cleaned mesh
  std::size_t welded_vertices = 0;  // that became one with another at the same place
  std::size_t unused_vertices = 0;  // left out: no facet has them
  Findings corners_in_sides;        // of other facets, within the tolerance: each side was cut there
  Findings degenerate;              // facets left out: a corner twice, or no height
  Findings duplicates;              // facets left out: another one has the same corners
  Findings flipped;                 // facets whose winding was turned
  Findings non_manifold_edges;      // shared by more than two facets, none of which is the others' neighbour
  std::size_t boundary_edges = 0;   // with one facet only
  LooseEdges loose_edges;           // of them, where the ground does not end
  double crack_m = 0;               // how near others must be for that
  std::size_t components = 0;       // parts that hang together across edges of exactly two facets
  std::size_t closed_components = 0;
  Findings one_sided_components;  // like a Moebius strip: no consistent winding exists
  Findings undecided_components;  // neither plan area nor volume says which side is out of the ground
  Findings vertical;              // facets, |n_z| at most vertical_n_z
  Findings overhanging;           // facets, n_z below that

  /// Whether every facet faces up, as those of a height field do. (Sheets may still lie one above the other.)
  [[nodiscard]] bool every_facet_faces_up() const { return vertical.count == 0 && overhanging.count == 0; }
  /// Whether there is anything that the user should look at, and not only know.
  [[nodiscard]] bool has_warnings() const;
  /// A few lines, without a line feed at the end. The first one sums up; those that begin with `warning:` come last.
  [[nodiscard]] std::string text() const;
};

}  // namespace talus
