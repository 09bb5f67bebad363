#include "talus/rocks/touch.hpp"

#include <algorithm>

namespace talus {

namespace {

// A polynomial of degree at most 4, lowest power first.
using Polynomial = std::array<double, 5>;

double value(const Polynomial& c, double t) { return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4]))); }

Polynomial derivative(const Polynomial& c) { return {c[1], 2 * c[2], 3 * c[3], 4 * c[4], 0}; }

// The root of a polynomial between a and b, where its values have opposite signs (fa at a): Newton steps kept inside a
// shrinking bracket.
double bracketed_root(const Polynomial& c, double a, double fa, double b) {
  const Polynomial slope = derivative(c);
  double t = 0.5 * (a + b);
  for (int i = 0; i < 100; ++i) {
    const double f = value(c, t);
    if (f == 0) return t;
    if ((f < 0) == (fa < 0)) {
      a = t;
    } else {
      b = t;
    }
    double next = t - f / value(slope, t);
    if (!(next > std::min(a, b) && next < std::max(a, b))) next = 0.5 * (a + b);
    if (std::abs(next - t) <= 1e-16 * std::abs(t) || next == a || next == b) return next;
    t = next;
  }
  return t;
}

// All roots in (0, t_max), in ascending order. Between neighbouring roots of its derivative a polynomial is monotone.
struct Roots {
  std::array<double, 4> t{};
  int count = 0;
  [[nodiscard]] const double* begin() const { return t.data(); }
  [[nodiscard]] const double* end() const { return t.data() + count; }
};

// The roots of a quadratic, without a difference of nearly equal numbers.
Roots quadratic_roots_within(const Polynomial& c, double t_max) {
  Roots roots;
  const auto note = [&](double t) {
    if (t > 0 && t < t_max) roots.t[static_cast<std::size_t>(roots.count++)] = t;
  };
  const double discriminant = c[1] * c[1] - 4 * c[2] * c[0];
  if (!(discriminant > 0)) return roots;  // a double root is not a change of sign
  const double q = -0.5 * (c[1] + std::copysign(std::sqrt(discriminant), c[1]));
  const double first = q / c[2], second = c[0] / q;  // not finite if there is only one root
  note(std::min(first, second));
  note(std::max(first, second));
  return roots;
}

Roots roots_within(const Polynomial& c, int degree, double t_max) {
  if (degree == 2) return quadratic_roots_within(c, t_max);
  Roots roots;
  const Roots turns = roots_within(derivative(c), degree - 1, t_max);
  double a = 0, fa = value(c, a);
  for (int i = 0; i <= turns.count; ++i) {
    const double b = i < turns.count ? turns.t[static_cast<std::size_t>(i)] : t_max;
    const double fb = value(c, b);
    if ((fa < 0) != (fb < 0)) roots.t[static_cast<std::size_t>(roots.count++)] = bracketed_root(c, a, fa, b);
    a = b;
    fa = fb;
  }
  return roots;
}

// The squared distance |d + v t + a t^2/2|^2, less radius^2, as a polynomial of time.
Polynomial squared_distance(const Vec3& d, const Vec3& v, const Vec3& a, double radius) {
  return {d.squared_norm() - radius * radius, 2 * d.dot(v), v.squared_norm() + d.dot(a), v.dot(a),
          0.25 * a.squared_norm()};
}

// The first time at which a polynomial takes a value; infinity if it does not.
double first_at(Polynomial c, double level, double t_max) {
  c[0] -= level;
  const Roots roots = roots_within(c, 4, t_max);
  return roots.count > 0 ? roots.t[0] : std::numeric_limits<double>::infinity();
}

// A polynomial between two times, by its Bernstein coefficients. Its values are between the smallest and the largest of
// them, and it has as many roots there as they change sign, or fewer by an even number (Farin, "Curves and surfaces for
// CAGD", 5th ed. 2002, sections 6.6 and 6.10).
struct BernsteinPart {
  std::array<double, 5> b;
  double from, to;

  BernsteinPart() = default;
  BernsteinPart(const Polynomial& c, const TimeWindow& window) : from(window.enter), to(window.leave) {
    const double a = from, h = to - from;
    // The powers of s in [0, 1] with t = a + s h.
    const double d0 = value(c, a);
    const double d1 = h * (c[1] + a * (2 * c[2] + a * (3 * c[3] + a * 4 * c[4])));
    const double d2 = h * h * (c[2] + a * (3 * c[3] + a * 6 * c[4]));
    const double d3 = h * h * h * (c[3] + a * 4 * c[4]);
    const double d4 = h * h * h * h * c[4];
    b = {d0, d0 + d1 * 0.25, d0 + d1 * 0.5 + d2 * (1.0 / 6), d0 + d1 * 0.75 + d2 * 0.5 + d3 * 0.25,
         d0 + d1 + d2 + d3 + d4};
  }
  [[nodiscard]] int sign_changes() const {
    int changes = 0;
    for (std::size_t k = 0; k < 4; ++k) changes += (b[k] < 0) != (b[k + 1] < 0) ? 1 : 0;
    return changes;
  }
  // Reduces this part to its second half, and returns the first.
  BernsteinPart split_off_first_half() {
    BernsteinPart first = *this;
    for (std::size_t left = 4; left > 0; --left) {  // de Casteljau
      first.b[4 - left] = b[0];
      for (std::size_t k = 0; k < left; ++k) b[k] = 0.5 * (b[k] + b[k + 1]);
    }
    first.b[4] = b[0];
    first.to = from = 0.5 * (from + to);
    return first;
  }
};

// The first time in a window at which a polynomial, positive at its start, falls through zero and meets(t) is true.
// Parts of the window with one change of sign have one root.
template <class Meets>
std::optional<double> first_fall(const Polynomial& c, const TimeWindow& window, Meets&& meets) {
  constexpr std::size_t most_halvings = 40;  // two roots that are closer are none: it only touches zero
  std::array<BernsteinPart, most_halvings + 2> waiting;
  std::array<std::size_t, most_halvings + 2> halvings;
  waiting[0] = BernsteinPart(c, window);
  halvings[0] = 0;
  for (std::size_t count = 1; count > 0;) {
    BernsteinPart& part = waiting[count - 1];
    const int changes = part.sign_changes();
    if (changes > 1 && halvings[count - 1] < most_halvings) {
      waiting[count] = part.split_off_first_half();
      halvings[count] = ++halvings[count - 1];
      ++count;
      continue;
    }
    --count;
    if (!(part.b[0] >= 0 && part.b[4] < 0)) continue;
    const double t = bracketed_root(c, part.from, part.b[0], part.to);
    if (meets(t)) return t;
  }
  return std::nullopt;
}

// The first fall of a squared distance, less radius^2, in a window, for which meets(t) is true.
template <class Meets>
std::optional<double> first_touch(const Polynomial& c, double radius, const TimeWindow& window, Meets&& meets) {
  const double slack = 2 * radius * contact_slack;
  if (window.is_empty()) return std::nullopt;
  if (value(c, window.enter) > slack) return first_fall(c, window, meets);
  for (const double t : falls(c, window.leave, slack)) {
    if (meets(t)) return t;
  }
  return std::nullopt;
}

}  // namespace

Falls falls(const std::array<double, 5>& c, double t_max, double slack) {
  Falls found;
  const auto note = [&](double t) { found.t[static_cast<std::size_t>(found.count++)] = t; };
  double free_from = 0;
  if (c[0] <= slack) {
    // For a rock that touches at the start, the derivative may be rounding. It is pressed in if it sinks by the slack
    // before it rises by the slack; then the contact is where it begins to sink.
    free_from = first_at(c, slack, t_max);
    const double sunk = first_at(c, std::min(c[0], 0.0) - slack, t_max);
    if (sunk < free_from) {
      double top = 0;
      const Polynomial slope = derivative(c);
      for (const double t : roots_within(slope, 3, sunk)) {
        if (value(derivative(slope), t) < 0) top = t;
      }
      note(top);
    }
  }
  for (const double t : roots_within(c, 4, t_max)) {
    if (found.count < 3 && t > free_from && value(derivative(c), t) < 0) note(t);
  }
  return found;
}

std::optional<double> touch_edge(const Parabola& path, const Vec3& a, const Vec3& e, double length, double radius,
                                 const TimeWindow& window) {
  const Vec3 from_a = path.p - a;
  const Vec3 d = from_a - from_a.dot(e) * e;
  const Vec3 v = path.v - path.v.dot(e) * e;
  const Vec3 acceleration = path.a - path.a.dot(e) * e;
  return first_touch(squared_distance(d, v, acceleration, radius), radius, window, [&](double t) {
    const double along = (path.at(t) - a).dot(e);
    return along >= 0 && along <= length;
  });
}

std::optional<double> touch_point(const Parabola& path, const Vec3& q, double radius, const TimeWindow& window) {
  return first_touch(squared_distance(path.p - q, path.v, path.a, radius), radius, window, [](double) { return true; });
}

}  // namespace talus
