#include "talus/rocks/hull_faces.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

/// The number of a face, which is added if it is in no plane of those before.
std::uint32_t add_face(HullFaces& into, const HullFace& added) {
  constexpr double rounding = 1e-9;
  const auto known = std::find_if(into.faces.begin(), into.faces.end(), [&](const HullFace& face) {
    return face.normal.dot(added.normal) > 1 - same_plane && std::abs(face.offset - added.offset) < rounding;
  });
  const auto number = static_cast<std::uint32_t>(known - into.faces.begin());
  if (known == into.faces.end()) into.faces.push_back(added);
  return number;
}

/// The corner that follows counter-clockwise, from x to z, about the origin; itself if there is none within half a
/// turn.
std::uint32_t next_in_section(std::span<const Vec3> corners, std::uint32_t i) {
  std::uint32_t next = i;
  double least = 0;
  for (std::uint32_t j = 0; j < corners.size(); ++j) {
    const double across = corners[i].x() * corners[j].z() - corners[i].z() * corners[j].x();
    if (!(across > 0)) continue;
    const double turn = std::atan2(across, corners[i].dot(corners[j]));
    if (next == i || turn < least) next = j, least = turn;
  }
  return next;
}

/// Lists at each corner what visit(at) says with at(corner, face, along), which it must say twice in the same order.
template <class Visit>
void list_at_corners(std::size_t corners, HullFaces& into, Visit&& visit) {
  into.first.assign(corners + 1, 0);
  visit([&](std::uint32_t corner, std::uint32_t, std::uint32_t) { ++into.first[corner + 1]; });
  for (std::size_t i = 0; i < corners; ++i) into.first[i + 1] += into.first[i];
  into.at_corners.resize(into.first.back());
  // Filled from behind: first[i + 1] comes down to the place of first[i].
  visit([&](std::uint32_t corner, std::uint32_t face, std::uint32_t along) {
    into.at_corners[--into.first[corner + 1]] = {face, along};
  });
  for (std::size_t i = 0; i < corners; ++i) into.first[i] = into.first[i + 1];
  into.first[corners] = static_cast<std::uint32_t>(into.at_corners.size());
}

}  // namespace

void find_faces(std::span<const Vec3> corners, std::span<const std::array<std::uint32_t, 3>> triangles,
                HullFaces& into) {
  into.faces.clear();
  into.all.clear();  // until the end: the face of each triangle, or of the side from each corner
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (!triangles.empty()) {
    for (const auto& t : triangles) {
      const Vec3& a = corners[t[0]];
      const Vec3 out = (corners[t[1]] - a).cross(corners[t[2]] - a);
      const double size = out.norm();
      // (Of a triangle without an area any face will do: those beside it are listed, too.)
      into.all.push_back(size > 0 ? add_face(into, {out / size, a.dot(out) / size}) : 0);
    }
    list_at_corners(count, into, [&](auto&& at) {
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& t = triangles[i];
        for (std::size_t k = 0; k < 3; ++k) at(t[k], into.all[i], t[(k + 1) % 3]);
      }
    });
  } else if (std::all_of(corners.begin(), corners.end(), [](const Vec3& c) { return c.y() == 0; })) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3 along = corners[next_in_section(corners, i)] - corners[i];
      const Vec3 out = Vec3{along.z(), 0, -along.x()}.normalized();
      into.all.push_back(add_face(into, {out, out.dot(corners[i])}));
    }
    list_at_corners(count, into, [&](auto&& at) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = next_in_section(corners, i);
        at(i, into.all[i], next);
        at(next, into.all[i], i);
      }
    });
  }
  into.all.resize(into.faces.size());
  for (std::uint32_t f = 0; f < into.faces.size(); ++f) into.all[f] = f;
}

}  // namespace talus
