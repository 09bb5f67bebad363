// One rock's trajectory, at any times.

#include <algorithm>

#include "arrays.hpp"
#include "away.hpp"
#include "bindings.hpp"
#include "prepared_model.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/trajectory/motion_at.hpp"
#include "vectors.hpp"

namespace talus::python {

namespace {

struct Trajectory {
  std::vector<PathPiece> pieces;    // local, in their order
  std::vector<Attitude> attitudes;  // of a block
  std::optional<RockBlock> block;
  LocalFrame frame;
  PackedRows events;
  RockRecord record;
  std::string seeder;

  [[nodiscard]] double duration() const { return record.outcome.end.time; }
  /// Its motion at a time [s], limited to its duration; in the project's coordinates.
  [[nodiscard]] Motion at(double time) const {
    if (pieces.empty() || time >= duration()) return in_project(record.outcome.end);
    return in_project(motion_at(pieces, time));
  }

 private:
  [[nodiscard]] Motion in_project(Motion motion) const {
    motion.position = frame.global_from_local(motion.position);
    return motion;
  }
};

std::shared_ptr<Trajectory> follow(const PreparedModel& prepared, std::uint64_t rock) {
  const Site& site = *prepared.site();
  const talus::Model& model = site.model;
  if (rock >= model.rocks()) {
    throw BadInput(Problem{.where = "rock=" + std::to_string(rock),
                           .what = "there is no such rock",
                           .why = "the project has rocks 0 to " + std::to_string(model.rocks() - 1)});
  }
  auto path = std::make_shared<Trajectory>();
  do_away_or_throw([&](const std::atomic<bool>&) {
    Simulator simulator(model);
    path->record = simulator.simulate(rock, true, true);
    simulator.log().for_each_piece([&](const PathPiece& piece) { path->pieces.push_back(piece); });
    path->attitudes = simulator.log().attitudes;
    path->block = block_of(model, rock);
    path->frame = model.frame;
    const TableContext context = TableContext::of(model);
    path->seeder = context.seeders[path->record.seeder.index];
    path->events.layout = layout_of<PathEventRow>([](std::string_view) { return 1; });
    PathEventRow row;
    const std::vector<PathRow>& rows = simulator.log().rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      fill(row, context, path->record, k, rows[k]);
      pack(row, path->events.layout, path->events.bytes);
    }
  });
  return path;
}

py::tuple motion_at(const Trajectory& path, const Numbers& time) {
  const py::ssize_t count = time.ndim() > 0 ? time.shape(0) : 0;
  const NumbersIn times(time, count);
  VectorsOut positions(count), velocities(count), spins(count);
  {
    const py::gil_scoped_release released;
    for (py::ssize_t k = 0; k < count; ++k) {
      const Motion motion = path.at(times[k]);
      positions.set(k, motion.position);
      velocities.set(k, motion.velocity);
      spins.set(k, motion.spin);
    }
  }
  return py::make_tuple(positions.array(), velocities.array(), spins.array());
}

/// The quaternions (w, x, y, z) of a block at times [s]; of a sphere or a point: None.
py::object orientation_of(const Trajectory& path, const Numbers& time) {
  if (!path.block) return py::none();
  const py::ssize_t count = time.ndim() > 0 ? time.shape(0) : 0;
  const NumbersIn times(time, count);
  py::array_t<double> turns({count, py::ssize_t{4}});
  auto out = turns.mutable_unchecked<2>();
  for (py::ssize_t k = 0; k < count; ++k) {
    const double at = std::clamp(times[k], 0.0, path.duration());
    const Orientation turn = orientation_at(path.attitudes, path.block->inertia, at);
    out(k, 0) = turn.w();
    for (py::ssize_t of = 0; of < 3; ++of) out(k, of + 1) = turn.xyz()[static_cast<std::size_t>(of)];
  }
  return turns;
}

/// The corners, triangles and principal moments of a block; None of a sphere or a point.
py::object block_parts(const Trajectory& path) {
  if (!path.block) return py::none();
  const auto& [corners, triangles, inertia] = *path.block;
  py::array_t<double> places({static_cast<py::ssize_t>(corners.size()), py::ssize_t{3}});
  auto place = places.mutable_unchecked<2>();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (std::size_t of = 0; of < 3; ++of)
      place(static_cast<py::ssize_t>(k), static_cast<py::ssize_t>(of)) = corners[k][of];
  }
  py::array_t<std::uint32_t> numbers({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  auto number = numbers.mutable_unchecked<2>();
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (std::size_t of = 0; of < 3; ++of)
      number(static_cast<py::ssize_t>(k), static_cast<py::ssize_t>(of)) = triangles[k][of];
  }
  py::array_t<double> moments(3);
  for (py::ssize_t of = 0; of < 3; ++of) moments.mutable_at(of) = inertia[static_cast<std::size_t>(of)];
  return py::make_tuple(places, numbers, moments);
}

}  // namespace

void bind_follow(py::module_& module) {
  py::class_<Trajectory, std::shared_ptr<Trajectory>>(module, "Trajectory")
      .def("at", &motion_at, py::arg("time"))
      .def("orientation_at", &orientation_of, py::arg("time"))
      .def("block", &block_parts)
      .def("events", [](const std::shared_ptr<Trajectory>& self) { return array_of(self->events, py::cast(self)); })
      .def_property_readonly("rock", [](const Trajectory& self) { return self.record.rock; })
      .def_readonly("seeder", &Trajectory::seeder)
      .def_property_readonly("duration", &Trajectory::duration)
      .def_property_readonly("mass", [](const Trajectory& self) { return self.record.body.mass; })
      .def_property_readonly("radius", [](const Trajectory& self) { return self.record.body.radius; })
      .def_property_readonly("end_reason", [](const Trajectory& self) { return name(self.record.outcome.reason); });
  module.def("follow", &follow, py::arg("model"), py::arg("rock"));
}

}  // namespace talus::python
