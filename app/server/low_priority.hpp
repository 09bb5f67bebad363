#pragma once
// Low priority for threads that simulate rocks, so that requests are answered promptly.

#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

namespace talus::server {

/// Lowers the priority of the calling thread from now on. (No effect on systems without priorities of single threads.)
void lower_priority_of_this_thread();

/// Runs functions on all cores at low priority. The threads, which are TBB's, keep the low priority afterwards: only
/// the superuser can raise it again.
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
