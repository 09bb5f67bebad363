#include "low_priority.hpp"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace talus::server {

void lower_priority_of_this_thread() {
#ifdef __linux__
  // On Linux each thread has its own priority. At this value it gets about a tenth of a busy core.
  constexpr int priority = 10;
  thread_local bool is_low = false;
  if (is_low) return;
  is_low = true;
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), priority);
#endif
}

}  // namespace talus::server
