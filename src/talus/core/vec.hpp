#pragma once
// Vectors of two and three coordinates: plain values, SI units. Frame: x and y on plan, z up, right-handed.
//
// They are in every equation and every state of a rock, so they are our own: bytes that can be copied, one order of
// operations on every processor (a b + (c d + e f)), and next to nothing for a compiler to read. Larger matrices are
// Eigen's.

#include <array>
#include <cmath>
#include <cstddef>

namespace talus {

template <std::size_t N>
requires(N == 2 || N == 3) class Vec {
 public:
  constexpr Vec() = default;
  constexpr Vec(double x, double y) requires(N == 2) : c_{x, y} {}
  constexpr Vec(double x, double y, double z) requires(N == 3) : c_{x, y, z} {}
  /// On plan as `xy`, at the height `z`.
  constexpr Vec(const Vec<2>& xy, double z) requires(N == 3) : c_{xy[0], xy[1], z} {}
  /// All coordinates are `s`.
  [[nodiscard]] static constexpr Vec all(double s) {
    return each([s](std::size_t) { return s; });
  }

  [[nodiscard]] constexpr double x() const { return c_[0]; }
  [[nodiscard]] constexpr double y() const { return c_[1]; }
  [[nodiscard]] constexpr double z() const requires(N == 3) { return c_[2]; }
  [[nodiscard]] constexpr double& x() { return c_[0]; }
  [[nodiscard]] constexpr double& y() { return c_[1]; }
  [[nodiscard]] constexpr double& z() requires(N == 3) { return c_[2]; }
  [[nodiscard]] constexpr double operator[](std::size_t i) const { return c_[i]; }
  [[nodiscard]] constexpr double& operator[](std::size_t i) { return c_[i]; }
  /// Its place on plan.
  [[nodiscard]] constexpr Vec<2> xy() const { return {c_[0], c_[1]}; }
  [[nodiscard]] constexpr const double* data() const { return c_; }
  [[nodiscard]] constexpr double* data() { return c_; }
  [[nodiscard]] static constexpr std::size_t size() { return N; }

  constexpr Vec& operator+=(const Vec& b) { return *this = *this + b; }
  constexpr Vec& operator-=(const Vec& b) { return *this = *this - b; }
  constexpr Vec& operator*=(double s) { return *this = *this * s; }
  constexpr Vec& operator/=(double s) { return *this = *this / s; }
  [[nodiscard]] friend constexpr Vec operator+(const Vec& a, const Vec& b) {
    return each([&](std::size_t i) { return a[i] + b[i]; });
  }
  [[nodiscard]] friend constexpr Vec operator-(const Vec& a, const Vec& b) {
    return each([&](std::size_t i) { return a[i] - b[i]; });
  }
  [[nodiscard]] friend constexpr Vec operator-(const Vec& a) {
    return each([&](std::size_t i) { return -a[i]; });
  }
  [[nodiscard]] friend constexpr Vec operator*(double s, const Vec& a) { return a * s; }
  [[nodiscard]] friend constexpr Vec operator*(const Vec& a, double s) {
    return each([&](std::size_t i) { return a[i] * s; });
  }
  [[nodiscard]] friend constexpr Vec operator/(const Vec& a, double s) {
    return each([&](std::size_t i) { return a[i] / s; });
  }
  [[nodiscard]] friend constexpr bool operator==(const Vec& a, const Vec& b) = default;

  [[nodiscard]] constexpr double dot(const Vec& b) const {
    if constexpr (N == 2)
      return c_[0] * b[0] + c_[1] * b[1];
    else
      return c_[0] * b[0] + (c_[1] * b[1] + c_[2] * b[2]);
  }
  [[nodiscard]] constexpr Vec cross(const Vec& b) const requires(N == 3) {
    return {c_[1] * b[2] - c_[2] * b[1], c_[2] * b[0] - c_[0] * b[2], c_[0] * b[1] - c_[1] * b[0]};
  }
  [[nodiscard]] constexpr double squared_norm() const { return dot(*this); }
  [[nodiscard]] double norm() const { return std::sqrt(squared_norm()); }
  /// Of length 1; the zero vector stays.
  [[nodiscard]] Vec normalized() const {
    const double square = squared_norm();
    return square > 0 ? *this / std::sqrt(square) : *this;
  }

  // ---- coordinate by coordinate ----
  /// The smaller and the larger of each coordinate; that of *this where one is not a number.
  [[nodiscard]] constexpr Vec min(const Vec& b) const {
    return each([&](std::size_t i) { return b[i] < c_[i] ? b[i] : c_[i]; });
  }
  [[nodiscard]] constexpr Vec max(const Vec& b) const {
    return each([&](std::size_t i) { return c_[i] < b[i] ? b[i] : c_[i]; });
  }
  [[nodiscard]] Vec abs() const {
    return each([&](std::size_t i) { return std::abs(c_[i]); });
  }
  /// To whole numbers, halves away from 0.
  [[nodiscard]] Vec rounded() const {
    return each([&](std::size_t i) { return std::round(c_[i]); });
  }
  [[nodiscard]] constexpr Vec times(const Vec& b) const {
    return each([&](std::size_t i) { return c_[i] * b[i]; });
  }
  [[nodiscard]] constexpr double sum() const {
    if constexpr (N == 2)
      return c_[0] + c_[1];
    else
      return c_[0] + (c_[1] + c_[2]);
  }
  [[nodiscard]] constexpr double largest() const {
    const double most = c_[0] < c_[1] ? c_[1] : c_[0];
    if constexpr (N == 2)
      return most;
    else
      return most < c_[2] ? c_[2] : most;
  }
  /// The number of the largest coordinate, the first of equal ones.
  [[nodiscard]] constexpr std::size_t place_of_largest() const {
    std::size_t place = 0;
    for (std::size_t i = 1; i < N; ++i) place = c_[place] < c_[i] ? i : place;
    return place;
  }
  /// Whether no coordinate is larger than that of `b`.
  [[nodiscard]] constexpr bool is_at_most(const Vec& b) const {
    bool is = c_[0] <= b[0] && c_[1] <= b[1];
    if constexpr (N == 3) is = is && c_[2] <= b[2];
    return is;
  }
  [[nodiscard]] bool is_finite() const {
    bool is = std::isfinite(c_[0]) && std::isfinite(c_[1]);
    if constexpr (N == 3) is = is && std::isfinite(c_[2]);
    return is;
  }

 private:
  template <class Of>
  [[nodiscard]] static constexpr Vec each(Of&& of) {
    if constexpr (N == 2)
      return {of(0), of(1)};
    else
      return {of(0), of(1), of(2)};
  }

  double c_[N] = {};
};

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

inline constexpr Vec3 unit_x{1, 0, 0}, unit_y{0, 1, 0}, unit_z{0, 0, 1};

/// A vector as rows of tables have it, and back.
[[nodiscard]] inline std::array<double, 3> coordinates(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline Vec3 vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// Standard gravity [m/s2], the default of RocFall2 and RocFall3.
inline constexpr double standard_gravity = 9.80665;

/// `v` without its component along the unit vector `n`.
[[nodiscard]] constexpr Vec3 tangential(const Vec3& v, const Vec3& n) { return v - v.dot(n) * n; }

/// `v` turned about the vertical by the angle with this cosine and sine (counter-clockwise seen from above).
[[nodiscard]] constexpr Vec3 turned(const Vec3& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()};
}

}  // namespace talus
