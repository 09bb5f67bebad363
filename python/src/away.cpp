#include "away.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <thread>

#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"

namespace talus::python {

namespace py = pybind11;

std::exception_ptr do_away(const std::function<void(const std::atomic<bool>& stop)>& work,
                           const std::function<void()>& report) {
  using namespace std::chrono_literals;
  std::atomic<bool> stop{false};
  std::promise<void> end;
  std::future<void> ended = end.get_future();
  std::exception_ptr interruption;
  keep_memory_reserve();
  std::thread thread([&] {
    try {
      const StopScope scope(&stop);
      work(stop);
      end.set_value();
    } catch (...) {
      end.set_exception(std::current_exception());
    }
  });
  for (;;) {
    {
      const py::gil_scoped_release released;
      if (interruption) {
        ended.wait();
        break;
      }
      if (ended.wait_for(50ms) == std::future_status::ready) break;
    }
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (report) report();
    } catch (...) {
      interruption = std::current_exception();
      stop = true;
    }
  }
  thread.join();
  try {
    ended.get();
  } catch (const Stopped&) {
    if (!interruption) throw;
  }
  return interruption;
}

void do_away_or_throw(const std::function<void(const std::atomic<bool>& stop)>& work) {
  if (const std::exception_ptr interruption = do_away(work)) std::rethrow_exception(interruption);
}

}  // namespace talus::python
