#pragma once
// Threads that simulate rocks make way for those that answer requests.

#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

namespace talus::server {

/// Lets the system prefer others to the calling thread from now on. (Where the system has no such thing for single
/// threads, nothing happens.)
void lower_priority_of_this_thread();

/// Runs functions with as many threads as there are cores, all of a low priority while they are at it and after: only
/// the superuser can raise it again, and the threads are TBB's, which wait for such work again.
class LowPriorityArena {
 public:
  LowPriorityArena() : observer_(arena_) { observer_.observe(true); }
  LowPriorityArena(const LowPriorityArena&) = delete;
  LowPriorityArena& operator=(const LowPriorityArena&) = delete;
  ~LowPriorityArena() { observer_.observe(false); }

  template <class Function>
  auto execute(Function&& function) {
    return arena_.execute(std::forward<Function>(function));
  }

 private:
  struct Observer : tbb::task_scheduler_observer {
    explicit Observer(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) {}
    void on_scheduler_entry(bool) override { lower_priority_of_this_thread(); }
  };

  tbb::task_arena arena_;
  Observer observer_;
};

}  // namespace talus::server
