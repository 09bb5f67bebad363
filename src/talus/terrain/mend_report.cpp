#include "talus/terrain/mend_report.hpp"

#include <fmt/format.h>

#include <string_view>

namespace talus {
namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

// ", for example at (1.000, 2.000, 3.000)"
std::string examples(const Findings& findings) {
  std::string out;
  for (const Vec3& at : findings.examples) {
    out += fmt::format("{} ({:.3f}, {:.3f}, {:.3f})", out.empty() ? "" : ",", at.x(), at.y(), at.z());
  }
  if (out.empty()) return out;
  return (findings.count > findings.examples.size() ? ", for example at" : ", at") + out;
}

}  // namespace

void Findings::add(const Vec3& where) {
  if (++count <= most_examples) examples.push_back(where);
}

bool MendReport::has_warnings() const {
  return non_manifold_edges.count + one_sided_components.count + undecided_components.count > 0;
}

std::string MendReport::text() const {
  std::string out = fmt::format("{}, {}, {} ({} closed), {}; {}", counted(facets, "facet", "facets"),
                                counted(vertices, "vertex", "vertices"), counted(components, "component", "components"),
                                closed_components, counted(boundary_edges, "boundary edge", "boundary edges"),
                                every_facet_faces_up()
                                    ? "every facet faces up"
                                    : fmt::format("{} vertical and {} overhanging", vertical.count, overhanging.count));
  if (vertical.count > 0) out += "\nvertical: " + counted(vertical.count, "facet", "facets") + examples(vertical);
  if (overhanging.count > 0) {
    out += "\noverhanging: " + counted(overhanging.count, "facet", "facets") + examples(overhanging);
  }
  if (welded_vertices > 0) {
    out += "\nwelded: " + counted(welded_vertices, "vertex, which lies", "vertices, which lie") + " where another does";
  }
  if (unused_vertices > 0) {
    out += "\nleft out: " + counted(unused_vertices, "vertex", "vertices") + " of no facet";
  }
  if (degenerate.count > 0) {
    out += "\nleft out: " + counted(degenerate.count, "facet", "facets") + " without area" + examples(degenerate);
  }
  if (duplicates.count > 0) {
    out += "\nleft out: " + counted(duplicates.count, "facet that repeats", "facets that repeat") + " another" +
           examples(duplicates);
  }
  if (flipped.count > 0) {
    out += "\nturned over to face out of the ground: " + counted(flipped.count, "facet", "facets") + examples(flipped);
  }
  if (non_manifold_edges.count > 0) {
    out += "\nwarning: " + counted(non_manifold_edges.count, "edge has", "edges have") +
           " more than two facets (which of them go on from each other is not known)" + examples(non_manifold_edges);
  }
  if (one_sided_components.count > 0) {
    out += "\nwarning: " + counted(one_sided_components.count, "component has", "components have") +
           " one side only, like a Moebius strip (each facet was turned up by itself)" + examples(one_sided_components);
  }
  if (undecided_components.count > 0) {
    out += "\nwarning: " + counted(undecided_components.count, "component does", "components do") +
           " not show which side is out of the ground (no area in plan, or no volume; the "
           "winding of most facets was kept)" +
           examples(undecided_components);
  }
  return out;
}

}  // namespace talus
