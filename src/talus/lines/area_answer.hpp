#pragma once
// What the rocks of a finished run do in a polygon on plan: which enter it, which stop in it, and how fast, high and
// strong they are there at most.
//
// A rock is inside while its centre is, on plan, by the rule of plan_polygon.hpp. Maxima are those of the parts of its
// path inside, exact along a flight (trajectory/piece_maxima.hpp). Height is the bounce height (rocks/heights.hpp).
// Checked by test/lines/area_answer_test.cpp.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/lines/asked_line.hpp"
#include "talus/lines/line_answer.hpp"
#include "talus/lines/rock_paths.hpp"
#include "talus/meshing/plan_polygon.hpp"

namespace talus {

struct AskedArea {
  std::vector<Vec2> ring;  // local; the first corner is not repeated
  PlanPolygon polygon;
  PlanBounds bounds;
  double area = 0;  // [m2]
};

/// The polygon with these corners. Throws BadInput with all its problems, which `where` names; corners off the terrain
/// are added to `warnings`.
[[nodiscard]] AskedArea drawn_area(const Model& model, std::span<const PlanPlace> corners, std::string_view where,
                                   Problems& warnings);

/// The parts of a path's parameter, up to `duration`, in which it is inside, ascending.
void parts_inside(const AskedArea& area, const Parabola& path, double duration,
                  std::vector<std::pair<double, double>>& parts);

/// A rock that is inside at some time.
struct RockInside {
  std::uint64_t rock = 0;
  bool stops = false;       // its path ends inside
  CrossingMaxima maxima{};  // inside, of the quantities that are shown
};

/// Nullopt if it is never inside.
[[nodiscard]] std::optional<RockInside> rock_inside(const Model& model, const AskedArea& area, const RockPath& path);

struct AreaAnswer {
  DesignPlan plan;                   // without lines: percentiles and confidence
  std::vector<RockInside> entering;  // in the order of the rocks
  std::uint64_t rocks = 0;           // asked: those whose paths are kept

  [[nodiscard]] std::vector<std::uint64_t> stopping() const;
};
[[nodiscard]] AreaAnswer ask_area(const Model& model, const project::DesignBasis& basis, const RockPaths& paths,
                                  const AskedArea& area);

}  // namespace talus
