#include "talus/meshing/cleaning_report.hpp"

#include <fmt/format.h>

namespace talus {

bool CleaningReport::has_warnings() const {
  return non_manifold_edges.count + loose_edges.cracks.count + loose_edges.covered.count + one_sided_components.count +
             undecided_components.count >
         0;
}

std::string CleaningReport::text() const {
  std::string out = fmt::format("{}, {}, {} ({} closed), {}; {}", counted(facets, "facet", "facets"),
                                counted(vertices, "vertex", "vertices"), counted(components, "component", "components"),
                                closed_components, counted(boundary_edges, "boundary edge", "boundary edges"),
                                every_facet_faces_up()
                                    ? "every facet faces up"
                                    : fmt::format("{} vertical and {} overhanging", vertical.count, overhanging.count));
  if (vertical.count > 0) out += "\nvertical: " + counted(vertical.count, "facet", "facets") + vertical.places();
  if (overhanging.count > 0) {
    out += "\noverhanging: " + counted(overhanging.count, "facet", "facets") + overhanging.places();
  }
  if (welded_vertices > 0) {
    out += "\nwelded: " + counted(welded_vertices, "vertex, which lies", "vertices, which lie") + " where another does";
  }
  if (corners_in_sides.count > 0) {
    out += "\njoined: " + counted(corners_in_sides.count, "corner that lies", "corners that lie") +
           " on the side of another facet, which was cut there" + corners_in_sides.places();
  }
  if (unused_vertices > 0) {
    out += "\nleft out: " + counted(unused_vertices, "vertex", "vertices") + " of no facet";
  }
  if (degenerate.count > 0) {
    out += "\nleft out: " + counted(degenerate.count, "facet", "facets") + " without area" + degenerate.places();
  }
  if (duplicates.count > 0) {
    out += "\nleft out: " + counted(duplicates.count, "facet that repeats", "facets that repeat") + " another" +
           duplicates.places();
  }
  if (flipped.count > 0) {
    out += "\nturned over to face out of the ground: " + counted(flipped.count, "facet", "facets") + flipped.places();
  }
  if (non_manifold_edges.count > 0) {
    out += "\nwarning: " + counted(non_manifold_edges.count, "edge has", "edges have") +
           " more than two facets (which of them go on from each other is not known)" + non_manifold_edges.places();
  }
  if (loose_edges.cracks.count > 0) {
    out +=
        "\nwarning: " + counted(loose_edges.cracks.count, "boundary edge lies", "boundary edges lie") +
        fmt::format(" within {:g} m of another facet (a crack: what slides or rolls to it may leave the model there)",
                    crack_m) +
        loose_edges.cracks.places();
  }
  if (loose_edges.covered.count > 0) {
    out += "\nwarning: " + counted(loose_edges.covered.count, "boundary edge lies", "boundary edges lie") +
           " below another facet and above none (what slides or rolls to it leaves the model there)" +
           loose_edges.covered.places();
  }
  if (one_sided_components.count > 0) {
    out += "\nwarning: " + counted(one_sided_components.count, "component has", "components have") +
           " one side only, like a Moebius strip (each facet was turned up by itself)" + one_sided_components.places();
  }
  if (undecided_components.count > 0) {
    out += "\nwarning: " + counted(undecided_components.count, "component does", "components do") +
           " not show which side is out of the ground (no area in plan, or no volume; the "
           "winding of most facets was kept)" +
           undecided_components.places();
  }
  return out;
}

}  // namespace talus
