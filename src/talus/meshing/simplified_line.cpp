#include "talus/meshing/simplified_line.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/register/point.hpp>

namespace talus {

namespace {

struct NumberedVertex {
  double x = 0, y = 0;
  std::size_t number = 0;
};

}  // namespace

}  // namespace talus

BOOST_GEOMETRY_REGISTER_POINT_2D(talus::NumberedVertex, double, boost::geometry::cs::cartesian, x, y)

namespace talus {

std::vector<std::size_t> vertices_to_keep(std::span<const Vec2> line, double tolerance) {
  boost::geometry::model::linestring<NumberedVertex> given, made;
  for (const Vec2& p : line) given.push_back({p.x(), p.y(), given.size()});
  boost::geometry::simplify(given, made, tolerance);
  std::vector<std::size_t> kept;
  for (const NumberedVertex& vertex : made) kept.push_back(vertex.number);
  return kept;
}

}  // namespace talus
