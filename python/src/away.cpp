#include "away.hpp"

#include <pthread.h>
#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"

namespace talus::python {

namespace py = pybind11;
using namespace std::chrono_literals;

namespace {

std::atomic<int> works{0};  // under way
std::atomic<bool> is_ending{false};
std::atomic<bool> was_forked_at_work{false};

struct WorkUnderWay {
  WorkUnderWay() { ++works; }
  WorkUnderWay(const WorkUnderWay&) = delete;
  WorkUnderWay& operator=(const WorkUnderWay&) = delete;
  ~WorkUnderWay() { --works; }
};

/// Once the interpreter has ended, threads that come back to it are killed, and their work would go on without it.
void end_work() {
  const py::gil_scoped_release released;
  is_ending = true;
  while (works > 0) std::this_thread::sleep_for(5ms);
}

void see_fork() { was_forked_at_work = was_forked_at_work || works.exchange(0) > 0; }

}  // namespace

std::exception_ptr do_away(const std::function<void(const std::atomic<bool>& stop)>& work,
                           const std::function<void()>& report) {
  if (was_forked_at_work) {
    throw std::runtime_error(
        "this process was forked while rocks were simulated, and cannot simulate any (use threads, or the start method "
        "\"spawn\" of multiprocessing)");
  }
  const WorkUnderWay under_way;
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
      if (interruption || is_ending) {
        stop = true;
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

void watch_process() {
  pthread_atfork(nullptr, nullptr, &see_fork);
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_work));
}

}  // namespace talus::python
