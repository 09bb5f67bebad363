#include "progress.hpp"

#include "away.hpp"

namespace talus::python {

std::exception_ptr do_and_tell(const std::function<void(const std::atomic<bool>& stop)>& work, const Course& course,
                               const Progress& progress) {
  std::uint64_t told = 0;
  const auto tell = [&] {
    if (!progress || course.planned == 0 || course.done == told) return;
    told = course.done;
    (*progress)(told, course.planned.load());
  };
  const std::exception_ptr interruption = do_away(work, tell);
  if (!interruption) tell();
  return interruption;
}

py::object interruption_object(const std::exception_ptr& interruption) {
  if (!interruption) return py::none();
  try {
    std::rethrow_exception(interruption);
  } catch (py::error_already_set& error) {
    return error.value();
  }
}

}  // namespace talus::python
