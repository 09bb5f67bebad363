#pragma once
// Long work that tells how far it is.

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>

#include "bindings.hpp"

namespace talus::python {

/// Called with what is done and what is planned.
using Progress = std::optional<py::function>;

/// How far the work is, as its threads report it. Nothing is told while `planned` is 0.
struct Course {
  std::atomic<std::uint64_t> done{0}, planned{0};
};

/// do_away(), telling the course whenever it has changed, and at the end of work that is not interrupted.
std::exception_ptr do_and_tell(const std::function<void(const std::atomic<bool>& stop)>& work, const Course& course,
                               const Progress& progress);

/// What interrupted the work, for a caller who gets the results until then; None if nothing did.
py::object interruption_object(const std::exception_ptr& interruption);

}  // namespace talus::python
