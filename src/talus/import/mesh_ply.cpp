#include <fmt/format.h>

#include <limits>

#include "talus/core/stop.hpp"
#include "talus/import/mesh_formats.hpp"
#include "talus/import/mesh_ply_body.hpp"
#include "talus/import/mesh_polygons.hpp"

namespace talus {
namespace ply {
namespace {

template <class Body>
void read_vertex(Body& body, const Element& element, PolygonMesh& mesh) {
  Vec3 position;
  for (const Property& property : element.properties) {
    const bool is_position = property.name == "x" || property.name == "y" || property.name == "z";
    if (property.length) {
      const auto length = body.length(property);
      if (!length || !body.skip(property, *length)) return;
    } else if (is_position) {
      const auto value = body.real(property);
      if (!value) return;
      position[property.name[0] - 'x'] = *value;
    } else if (!body.skip(property, 1)) {
      return;
    }
  }
  mesh.vertices.push_back(position);
  body.end();
}

template <class Body>
bool read_corners(Body& body, const Property& property, PolygonMesh& mesh, MeshProblems& problems) {
  const auto length = body.length(property);
  if (!length) return false;
  for (std::uint64_t i = 0; i < *length; ++i) {
    const auto index = body.whole(property);
    if (!index) return false;
    if (*index < 0 || *index > std::numeric_limits<std::uint32_t>::max()) {
      problems.refuse(body.place(), fmt::format("vertex {} does not exist", *index), "PLY numbers vertices from 0");
      return false;
    }
    mesh.corners.push_back(static_cast<std::uint32_t>(*index));
  }
  return true;
}

template <class Body>
void read_face(Body& body, const Element& element, PolygonMesh& mesh, MeshProblems& problems) {
  for (const Property& property : element.properties) {
    if (property.name == "vertex_indices" || property.name == "vertex_index") {
      if (!read_corners(body, property, mesh, problems)) return;
    } else if (property.length) {
      const auto length = body.length(property);
      if (!length || !body.skip(property, *length)) return;
    } else if (!body.skip(property, 1)) {
      return;
    }
  }
  mesh.ends.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  if (body.line() > 0) mesh.lines.push_back(body.line());
  body.end();
}

template <class Body>
void read_other(Body& body, const Element& element) {
  for (const Property& property : element.properties) {
    std::optional<std::uint64_t> count = 1;
    if (property.length) count = body.length(property);
    if (!count || !body.skip(property, *count)) return;
  }
  body.end();
}

template <class Body>
PolygonMesh read_body(Body body, const Header& header, MeshProblems& problems) {
  PolygonMesh mesh;
  for (const Element& element : header.elements) {
    if (element.count == 0) continue;
    const std::uint64_t room = body.room_for(element);
    if (element.count > room) {
      problems.stop(
          {element.line, ""}, fmt::format("the header declares {} of {}", element.count, in_quotes(element.name)),
          fmt::format("the rest of the file has room for {} at most", room), "The file may have been cut short");
    }
    if (element.name == "vertex") mesh.vertices.reserve(element.count);
    if (element.name == "face") mesh.ends.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      stop_point(i);
      body.begin(element, i);
      if (element.name == "vertex") {
        read_vertex(body, element, mesh);
      } else if (element.name == "face") {
        read_face(body, element, mesh, problems);
      } else {
        read_other(body, element);
      }
    }
  }
  body.finish();
  return mesh;
}

PolygonMesh read_any_body(const Header& header, MeshProblems& problems) {
  switch (header.encoding) {
    case Encoding::text:
      return read_body(TextBody{header, problems}, header, problems);
    case Encoding::little_endian:
      return read_body(BinaryBody<boost::endian::order::little>{header, problems}, header, problems);
    case Encoding::big_endian:
      break;
  }
  return read_body(BinaryBody<boost::endian::order::big>{header, problems}, header, problems);
}

}  // namespace
}  // namespace ply

RawMesh read_ply(std::string_view bytes, MeshProblems& problems) {
  const ply::Header header = ply::read_header(bytes, problems);
  if (!header.declares("vertex")) problems.stop({}, "has no vertices", "the header declares no element vertex");
  if (!header.declares("face")) {
    problems.stop({}, "has no faces", "the header declares no element face",
                  header.declares("tristrips") ? "Write triangles instead of strips" : "Triangulate the points first");
  }
  PolygonMesh mesh = ply::read_any_body(header, problems);
  problems.throw_if_any();
  return triangulated(std::move(mesh), problems);
}

}  // namespace talus
