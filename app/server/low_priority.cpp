#include "low_priority.hpp"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace talus::server {

void lower_priority_of_this_thread() {
#ifdef __linux__
  // On Linux a thread has a priority of its own. A tenth of the time is left to it where others want all.
  constexpr int priority = 10;
  thread_local bool is_low = false;
  if (is_low) return;
  is_low = true;
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), priority);
#endif
}

}  // namespace talus::server
