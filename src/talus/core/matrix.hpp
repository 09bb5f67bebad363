#pragma once
// Matrices of three rows and columns: plain values, like the vectors of vec.hpp and with the same order of operations.

#include <array>

#include "talus/core/vec.hpp"

namespace talus {

/// Its columns are the images of unit_x, unit_y and unit_z.
struct Mat3 {
  std::array<Vec3, 3> rows;

  [[nodiscard]] static constexpr Mat3 diagonal(const Vec3& d) {
    return {{Vec3{d[0], 0, 0}, Vec3{0, d[1], 0}, Vec3{0, 0, d[2]}}};
  }
  [[nodiscard]] static constexpr Mat3 of_columns(const Vec3& a, const Vec3& b, const Vec3& c) {
    return Mat3{{a, b, c}}.transposed();
  }
  [[nodiscard]] constexpr Vec3 column(std::size_t i) const { return {rows[0][i], rows[1][i], rows[2][i]}; }
  [[nodiscard]] constexpr Mat3 transposed() const { return {{column(0), column(1), column(2)}}; }

  [[nodiscard]] friend constexpr Vec3 operator*(const Mat3& m, const Vec3& v) {
    return {m.rows[0].dot(v), m.rows[1].dot(v), m.rows[2].dot(v)};
  }
  [[nodiscard]] friend constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
    return of_columns(a * b.column(0), a * b.column(1), a * b.column(2));
  }
  [[nodiscard]] friend constexpr Mat3 operator+(const Mat3& a, const Mat3& b) {
    return {{a.rows[0] + b.rows[0], a.rows[1] + b.rows[1], a.rows[2] + b.rows[2]}};
  }
  [[nodiscard]] friend constexpr Mat3 operator*(double s, const Mat3& m) {
    return {{s * m.rows[0], s * m.rows[1], s * m.rows[2]}};
  }
  [[nodiscard]] friend constexpr bool operator==(const Mat3& a, const Mat3& b) = default;

  /// x with *this * x = b, by Cramer's rule. The determinant must not be 0.
  [[nodiscard]] constexpr Vec3 solve(const Vec3& b) const {
    const Vec3 p = column(0), q = column(1), r = column(2), qr = q.cross(r);
    return Vec3{b.dot(qr), p.dot(b.cross(r)), p.dot(q.cross(b))} / p.dot(qr);
  }
  /// The determinant must not be 0.
  [[nodiscard]] constexpr Mat3 inverse() const {
    const Vec3 p = column(0), q = column(1), r = column(2), qr = q.cross(r);
    return (1 / p.dot(qr)) * Mat3{{qr, r.cross(p), p.cross(q)}};
  }
};

/// a b^T.
[[nodiscard]] constexpr Mat3 outer_product(const Vec3& a, const Vec3& b) { return {{a[0] * b, a[1] * b, a[2] * b}}; }

}  // namespace talus
