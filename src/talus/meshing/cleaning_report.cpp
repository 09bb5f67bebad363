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
    out += "\nwelded: " + counted(welded_vertices, "vertex", "vertices") + " at the position of another";
  }
  if (corners_in_sides.count > 0) {
    out += "\njoined: " + counted(corners_in_sides.count, "corner", "corners") +
           " on the side of another facet, which was split there" + corners_in_sides.places();
  }
  if (unused_vertices > 0) {
    out += "\nleft out: " + counted(unused_vertices, "vertex", "vertices") + " that no facet uses";
  }
  if (degenerate.count > 0) {
    out += "\nleft out: " + counted(degenerate.count, "facet", "facets") + " without area" + degenerate.places();
  }
  if (duplicates.count > 0) {
    out += "\nleft out: " + counted(duplicates.count, "facet that repeats", "facets that repeat") + " another" +
           duplicates.places();
  }
  if (flipped.count > 0) {
    out += "\nflipped to face out of the ground: " + counted(flipped.count, "facet", "facets") + flipped.places();
  }
  if (non_manifold_edges.count > 0) {
    out += "\nwarning: " + counted(non_manifold_edges.count, "edge has", "edges have") +
           " more than two facets (it is not known which of them are neighbours)" + non_manifold_edges.places();
  }
  if (loose_edges.cracks.count > 0) {
    out += "\nwarning: " + counted(loose_edges.cracks.count, "boundary edge lies", "boundary edges lie") +
           fmt::format(
               " within {:g} m of another facet (a crack: a rock that slides or rolls to it may leave the model there)",
               crack_m) +
           loose_edges.cracks.places();
  }
  if (loose_edges.covered.count > 0) {
    out += "\nwarning: " + counted(loose_edges.covered.count, "boundary edge lies", "boundary edges lie") +
           " below another facet and above none (a rock that slides or rolls to it leaves the model there)" +
           loose_edges.covered.places();
  }
  if (one_sided_components.count > 0) {
    out += "\nwarning: " + counted(one_sided_components.count, "component has", "components have") +
           " one side only, like a Moebius strip (each facet was turned to face up)" + one_sided_components.places();
  }
  if (undecided_components.count > 0) {
    out += "\nwarning: " + counted(undecided_components.count, "component has", "components have") +
           " no clear outer side (no area in plan, or no volume; the winding of most facets was kept)" +
           undecided_components.places();
  }
  return out;
}

}  // namespace talus
