// The terrain of a model: its queries, for lists of places and flights.

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "bindings.hpp"
#include "memory_run.hpp"
#include "prepared_model.hpp"
#include "talus/model/cut_section.hpp"
#include "vectors.hpp"

namespace talus::python {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// NaN: no ground there.
py::array_t<double> elevation(const Model& built, const Numbers& x, const Numbers& y) {
  const py::ssize_t count = x.ndim() > 0 ? x.shape(0) : 0;
  const NumbersIn xs(x, count), ys(y, count);
  NumbersOut heights(count);
  {
    const py::gil_scoped_release released;
    const Vec3& origin = built.frame.origin;
    std::visit(
        [&](const auto& surface) {
          for (py::ssize_t k = 0; k < count; ++k) {
            const bool is_place = std::isfinite(xs[k]) && std::isfinite(ys[k]);
            const auto z = is_place ? surface.elevation(xs[k] - origin.x(), ys[k] - origin.y()) : std::nullopt;
            heights.set(k, z ? *z + origin.z() : none);
          }
        },
        *built.surface);
  }
  return heights.array();
}

/// Times (NaN: no contact), places and normals.
py::tuple first_contact(const Model& built, const Numbers& position, const Numbers& velocity, const Numbers& radius,
                        double gravity, double t_max) {
  const py::ssize_t count = radius.ndim() > 0 ? radius.shape(0) : 0;
  const VectorsIn p(position, count), v(velocity, count);
  const NumbersIn r(radius, count);
  NumbersOut times(count), facets(count);
  VectorsOut places(count), normals(count);
  {
    const py::gil_scoped_release released;
    std::visit(
        [&](const auto& surface) {
          for (py::ssize_t k = 0; k < count; ++k) {
            const Parabola path{built.frame.local_from_global(p[k]), v[k], {0, 0, -gravity}};
            const bool is_flight = path.p.is_finite() && path.v.is_finite() && std::isfinite(r[k]);
            const auto contact = is_flight ? surface.first_contact(path, r[k], t_max) : std::nullopt;
            times.set(k, contact ? contact->t : none);
            places.set(k, contact ? built.frame.global_from_local(path.at(contact->t)) : Vec3::all(none));
            normals.set(k, contact ? contact->normal : Vec3::all(none));
            facets.set(k, contact ? built.parts.of(surface.source(contact->facet)) : -1.0);
          }
        },
        *built.surface);
  }
  return py::make_tuple(times.array(), places.array(), normals.array(), facets.array());
}

/// West, east, south, north, lowest and highest.
py::tuple bounds(const Model& built) {
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *built.surface);
  const Vec3 low = built.frame.global_from_local(box.low), high = built.frame.global_from_local(box.high);
  return py::make_tuple(low.x(), high.x(), low.y(), high.y(), low.z(), high.z());
}

/// Distances along the line on plan, and places.
py::tuple ground_along(const Model& built, const Numbers& x, const Numbers& y, double tolerance) {
  const py::ssize_t count = x.ndim() > 0 ? x.shape(0) : 0;
  const NumbersIn xs(x, count), ys(y, count);
  std::vector<std::array<double, 2>> line;
  for (py::ssize_t k = 0; k < count; ++k) line.push_back({xs[k], ys[k]});
  std::vector<SectionVertex> cut;
  {
    const py::gil_scoped_release released;
    cut = cut_section(*built.surface, built.frame, line, tolerance, "line");
  }
  const auto vertices = static_cast<py::ssize_t>(cut.size());
  NumbersOut distances(vertices);
  VectorsOut places(vertices);
  for (py::ssize_t k = 0; k < vertices; ++k) {
    const SectionVertex& vertex = cut[static_cast<std::size_t>(k)];
    distances.set(k, vertex.distance);
    places.set(k, vertex.place);
  }
  return py::make_tuple(distances.array(), places.array());
}

template <class Owner, class ModelOf>
void bind_queries(py::module_& module, ModelOf model_of) {
  module.def("elevation",
             [=](const Owner& owner, const Numbers& x, const Numbers& y) { return elevation(model_of(owner), x, y); });
  module.def("first_contact", [=](const Owner& owner, const Numbers& position, const Numbers& velocity,
                                  const Numbers& radius, double gravity, double t_max) {
    return first_contact(model_of(owner), position, velocity, radius, gravity, t_max);
  });
  module.def("section", [=](const Owner& owner, const Numbers& x, const Numbers& y, double tolerance) {
    return ground_along(model_of(owner), x, y, tolerance);
  });
  module.def("bounds", [=](const Owner& owner) { return bounds(model_of(owner)); });
}

}  // namespace

void bind_surface(py::module_& module) {
  bind_queries<PreparedModel>(module, [](const PreparedModel& model) -> const Model& { return model.site()->model; });
  bind_queries<MemoryRun>(module, [](const MemoryRun& run) -> const Model& { return run.site().model; });
}

}  // namespace talus::python
