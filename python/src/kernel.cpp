// Single impacts and flights.

#include "bindings.hpp"
#include "talus/impact/law.hpp"
#include "talus/rocks/state_with_drag.hpp"
#include "vectors.hpp"

namespace talus::python {

namespace {

struct Impacts {
  VectorsIn velocity, spin, normal;
  NumbersIn mass, radius, rn, rt, mu, rolling;
};

template <class Law>
void rebounds(const Law& law, const Impacts& in, py::ssize_t count, VectorsOut& velocity, VectorsOut& spin) {
  for (py::ssize_t k = 0; k < count; ++k) {
    const Vec3 v = in.velocity[k], w = in.spin[k], n = in.normal[k];
    const Rock rock{in.mass[k], in.radius[k], inertia_of_sphere(in.mass[k], in.radius[k])};
    const ContactSet touched = ContactPoint{-rock.radius * n, n};
    const Rebound after = law.rebound(
        Approach{v, w, touched, rock},
        [&] {
          return Restitution{in.rn[k], in.rt[k]};
        },
        [&] {
          return ContactFriction{in.mu[k], in.rolling[k]};
        });
    velocity.set(k, after.velocity);
    spin.set(k, after.spin);
  }
}

py::tuple rebound(const std::string& law, const Numbers& velocity, const Numbers& spin, const Numbers& normal,
                  const Numbers& mass, const Numbers& radius, const Numbers& rn, const Numbers& rt, const Numbers& mu,
                  const Numbers& rolling) {
  const py::ssize_t count = velocity.ndim() > 0 ? velocity.shape(0) : 0;
  const Impacts in{{velocity, count}, {spin, count}, {normal, count}, {mass, count},   {radius, count},
                   {rn, count},       {rt, count},   {mu, count},     {rolling, count}};
  VectorsOut v(count), w(count);
  {
    const py::gil_scoped_release released;
    if (law == "crsp") rebounds(CrspLaw{}, in, count, v, w);
    if (law == "plain") rebounds(PlainImpact{}, in, count, v, w);
    if (law == "rigid_sphere") rebounds(RigidSphereImpact{}, in, count, v, w);
  }
  return py::make_tuple(v.array(), w.array());
}

py::tuple flight_at(const Numbers& position, const Numbers& velocity, const Numbers& time, double gravity,
                    double rate) {
  const py::ssize_t count = time.ndim() > 0 ? time.shape(0) : 0;
  const VectorsIn p(position, count), v(velocity, count);
  const NumbersIn t(time, count);
  VectorsOut positions(count), velocities(count);
  {
    const py::gil_scoped_release released;
    const LinearDrag drag{rate, Vec3(0, 0, -gravity)};
    for (py::ssize_t k = 0; k < count; ++k) {
      const FlightState state = state_with_drag(p[k], v[k], drag, t[k]);
      positions.set(k, state.place);
      velocities.set(k, state.velocity);
    }
  }
  return py::make_tuple(positions.array(), velocities.array());
}

}  // namespace

void bind_kernel(py::module_& module) {
  module.def("rebound", &rebound);
  module.def("flight_at", &flight_at);
}

}  // namespace talus::python
