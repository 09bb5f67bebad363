#pragma once
// Raw meshes for tests of cleaning, and what is true of every cleaned mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus::testing_tools {

using RawTriangle = std::array<std::uint32_t, 3>;

[[nodiscard]] inline Vec3 normal(const CleanMesh& mesh, std::size_t i) {
  const RawTriangle& t = mesh.triangles[i];
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
}

/// Checks what is true of every cleaned mesh: indices exist, and neighbours link to each other across the same edge and
/// run along it in opposite directions (unless the component has one side only).
inline void expect_sound(const CleanMesh& mesh) {
  ASSERT_EQ(mesh.neighbours.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.original.size(), mesh.triangles.size());
  EXPECT_TRUE(std::is_sorted(mesh.original.begin(), mesh.original.end()));
  EXPECT_EQ(mesh.report.facets, mesh.triangles.size());
  EXPECT_EQ(mesh.report.vertices, mesh.vertices.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(mesh.triangles[i][k], mesh.vertices.size());
      if (!mesh.neighbours[i][k]) continue;
      const std::uint32_t from = mesh.triangles[i][k];
      const std::uint32_t to = mesh.triangles[i][(k + 1) % 3];
      const std::uint32_t j = (*mesh.neighbours[i][k]).index;
      ASSERT_LT(j, mesh.triangles.size());
      int found = 0;
      for (std::size_t m = 0; m < 3; ++m) {
        const std::uint32_t a = mesh.triangles[j][m];
        const std::uint32_t b = mesh.triangles[j][(m + 1) % 3];
        if (!((a == to && b == from) || (a == from && b == to))) continue;
        ++found;
        EXPECT_EQ(mesh.neighbours[j][m], Neighbour{FacetId{i}});
        if (mesh.report.one_sided_components.count == 0) {
          EXPECT_EQ(a, to) << "facets " << i << " and " << j;
        }
      }
      EXPECT_EQ(found, 1);
    }
  }
}

/// A random TIN: a grid of n by n cells with jittered vertices and random heights, wound to face up (vertices move by
/// less than a quarter of a cell, so no triangle can turn over).
[[nodiscard]] inline RawMesh random_tin(std::uint32_t n, std::mt19937_64& random, const Vec3& origin = Vec3{}) {
  std::uniform_real_distribution<double> jitter{-0.2, 0.2};
  RawMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      mesh.vertices.push_back(origin + Vec3{x + jitter(random), y + jitter(random), 5 * jitter(random)});
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

/// Reverses the winding of about half of the triangles.
inline void flip_at_random(RawMesh& mesh, std::mt19937_64& random) {
  for (RawTriangle& t : mesh.triangles) {
    if (random() % 2 == 0) std::swap(t[0], t[1]);
  }
}

/// The same triangles without shared vertices, as in STL.
[[nodiscard]] inline RawMesh soup(const RawMesh& mesh) {
  RawMesh out;
  for (const RawTriangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    for (const std::uint32_t v : t) out.vertices.push_back(mesh.vertices[v]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

inline void add_quad(RawMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// A box with its lowest corner at `at`; normals out.
[[nodiscard]] inline RawMesh raw_box(const Vec3& at, const Vec3& size) {
  RawMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(at + Vec3{i % 2 * size.x(), i / 2 % 2 * size.y(), i / 4 * size.z()});
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 3, 2, 6, 7);
  add_quad(mesh, 2, 0, 4, 6);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

[[nodiscard]] inline RawMesh joined(RawMesh a, const RawMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const RawTriangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

/// A profile (x, z) extruded along y by 1 m; two triangles per segment.
[[nodiscard]] inline RawMesh raw_extrusion(const std::vector<Vec2>& profile, bool closed = false) {
  RawMesh mesh;
  for (const Vec2& p : profile) {
    mesh.vertices.emplace_back(p.x(), 0, p.y());
    mesh.vertices.emplace_back(p.x(), 1, p.y());
  }
  const auto n = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    add_quad(mesh, 2 * i, 2 * j, 2 * j + 1, 2 * i + 1);
  }
  return mesh;
}

[[nodiscard]] inline RawMesh moebius_strip(std::uint32_t steps) {
  RawMesh mesh;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps;
    for (const double side : {-1.0, 1.0}) {
      const double radius = 3 + side * std::cos(angle / 2);
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2));
    }
  }
  for (std::uint32_t i = 0; i + 1 < steps; ++i) add_quad(mesh, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  add_quad(mesh, 2 * steps - 2, 1, 0, 2 * steps - 1);
  return mesh;
}

/// The text with which cleaning refuses a mesh.
[[nodiscard]] inline std::string refusal(RawMesh mesh, const CleaningOptions& options = {.source = "slope.obj"}) {
  try {
    static_cast<void>(clean(std::move(mesh), options));
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace talus::testing_tools
