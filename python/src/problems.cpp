#include "problems.hpp"

#include "bindings.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"
#include "talus/core/utf8.hpp"

namespace talus::python {

namespace {

py::object text(const std::string& given) { return given.empty() ? py::object(py::none()) : py::str(as_utf8(given)); }

/// The same problem for someone who writes Python: keyword arguments in place of options of the command line.
Problem in_python(Problem problem) {
  const py::object spoken = py::module_::import("talus.spoken").attr("spoken");
  const bool is_of_setting = problem.file.starts_with("--set ");
  for (std::string* part : {&problem.file, &problem.where, &problem.what, &problem.why, &problem.hint}) {
    if (!part->empty()) *part = spoken(as_utf8(*part), is_of_setting).cast<std::string>();
  }
  problem.option.clear();
  return problem;
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const BadInput& bad) {
    const py::object type = py::module_::import("talus.problems").attr("BadInput");
    PyErr_SetObject(type.ptr(), type(as_python(bad.problems())).ptr());
  } catch (const OutOfMemory& error) {
    PyErr_SetString(PyExc_MemoryError, error.what());
  } catch (const Stopped&) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
}

}  // namespace

py::list as_python(const Problems& problems) {
  const py::object make = py::module_::import("talus.problems").attr("Problem");
  py::list list;
  for (const Problem& given : problems.list()) {
    const Problem problem = in_python(given);
    list.append(make(py::arg("severity") = problem.severity == Severity::error ? "error" : "warning",
                     py::arg("file") = text(problem.file),
                     py::arg("line") = problem.line > 0 ? py::object(py::int_(problem.line)) : py::none(),
                     py::arg("where") = text(problem.where), py::arg("what") = text(problem.what),
                     py::arg("why") = text(problem.why), py::arg("hint") = text(problem.hint),
                     py::arg("path") = text(problem.path), py::arg("text") = py::str(as_utf8(problem.text())),
                     py::arg("kind") = text(std::string(word(problem.kind)))));
  }
  return list;
}

void bind_problems(py::module_&) { py::register_exception_translator(&translate); }

}  // namespace talus::python
