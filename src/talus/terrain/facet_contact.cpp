#include "talus/terrain/facet_contact.hpp"

namespace talus {

void meet_point(const Parabola& path, const Triangle& corner, FacetName name, const SupportPlanes& left,
                ContactCandidate& best) {
  const Vec3 first = corner[1] - corner[0], last = corner[2] - corner[0];
  // The normal is normalized only when needed: times do not depend on its length.
  const Vec3 n = first.cross(last);
  const double vn = n.dot(path.v), an = n.dot(path.a);
  if (vn >= 0 && an >= 0) return;
  const Vec3 from_corner = path.p - corner[0];
  const double h0 = n.dot(from_corner);
  const auto t = falling_root(h0, vn, an, contact_slack * n.abs().sum());
  if (!t || !best.beaten_by(*t, Feature::facet, name.source)) return;

  // Distances from the sides, times the lengths of n and of the side; their sum is the square of n.
  const double n2 = n.squared_norm(), n_length = std::sqrt(n2);
  const auto is_over = [&](double at, auto&& slack_there) {
    const Vec3 q = from_corner + at * path.v + (0.5 * at * at) * path.a;
    const double inside_first = n.dot(first.cross(q)), inside_last = n.dot(q.cross(last));
    const double inside_middle = n2 - inside_first - inside_last;
    if (std::min({inside_first, inside_middle, inside_last}) >= 0) return true;
    const double slack = slack_there() * n_length;
    return inside_first >= -slack * first.norm() && inside_last >= -slack * last.norm() &&
           inside_middle >= -slack * (last - first).norm();
  };
  const Vec3 unit = n / n_length;
  const bool is_met = is_over(*t, [&] {
    const Vec3 arriving = path.velocity(*t);
    return outline_slack(arriving.norm(), -unit.dot(arriving));
  });
  if (!is_met) return;
  const double scale = 1 / n_length;
  if (left.excludes(FacetId{name.facet}, unit, h0 * scale, vn * scale, an * scale,
                    [&](double at) { return is_over(at, [] { return contact_slack; }); })) {
    return;
  }
  best = {*t, unit, name.facet, name.source, Feature::facet};
}

// Ericson, "Real-time collision detection" (2005), section 5.1.5.
Vec3 closest_point(const Triangle& corner, const Vec3& p) {
  const auto& [a, b, c] = corner;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double scale = 1 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

}  // namespace talus
