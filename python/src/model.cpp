#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include "away.hpp"
#include "bindings.hpp"
#include "memory_run.hpp"
#include "prepared_model.hpp"
#include "problems.hpp"
#include "progress.hpp"
#include "talus/core/memory_reserve.hpp"

namespace talus::python {

namespace {

using PreparedPointer = std::shared_ptr<PreparedModel>;

PreparedPointer prepare(std::shared_ptr<GivenProject> given) {
  PreparedPointer model;
  do_away_or_throw([&](const std::atomic<bool>&) { model = std::make_shared<PreparedModel>(std::move(given)); });
  return model;
}

/// Returns the run, and the exception that stopped it or None.
py::tuple run(const PreparedModel& model, std::vector<std::string> settings, std::optional<std::int64_t> rocks,
              std::optional<std::uint64_t> seed, int threads, const Progress& progress) {
  const project::Overrides overrides{std::move(settings), rocks, seed};
  std::shared_ptr<MemoryRun> run;
  Course course;
  const auto work = [&](const std::atomic<bool>& stop) {
    std::shared_ptr<MemoryRun> begun;
    const auto site = model.site_with(overrides);
    course.planned = site->model.rocks();
    try {
      begun = std::make_shared<MemoryRun>(site);
    } catch (const std::bad_alloc&) {
      throw OutOfMemory(fmt::format(
          "not enough memory for the end points of {} rocks (keep fewer, with output={{\"endpoints\": N}}, or run the "
          "project with the program)",
          course.planned.load()));
    }
    begun->simulate(threads, stop, course.done);
    run = std::move(begun);
  };
  const std::exception_ptr interruption = do_and_tell(work, course, progress);
  if (interruption && !run) std::rethrow_exception(interruption);
  return py::make_tuple(run, interruption_object(interruption));
}

}  // namespace

void bind_model(py::module_& module) {
  py::class_<PreparedModel, PreparedPointer>(module, "Model")
      .def(py::init(&prepare), py::arg("project").none(false))
      .def("run", &run, py::arg("settings"), py::arg("rocks"), py::arg("seed"), py::arg("threads"), py::arg("progress"))
      .def_property_readonly("warnings", [](const PreparedModel& self) { return as_python(self.site()->warnings); })
      .def_property_readonly("rocks", [](const PreparedModel& self) { return self.site()->model.rocks(); })
      .def_property_readonly("crs_wkt", [](const PreparedModel& self) { return self.site()->model.crs_wkt; });
}

}  // namespace talus::python
