#include "talus/core/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace talus {

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

std::uint64_t limit_in(const char* file) {
  std::ifstream in(file);
  std::uint64_t limit = no_limit;
  if (!(in >> limit)) return no_limit;  // "max", or no such file
  return limit;
}

}  // namespace

std::uint64_t usable_memory() {
  std::uint64_t most = no_limit;
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages > 0 && page > 0) most = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  most = std::min(most, limit_in("/sys/fs/cgroup/memory.max"));
  most = std::min(most, limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"));
  for (const auto which : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (getrlimit(which, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      most = std::min<std::uint64_t>(most, limit.rlim_cur);
  }
  return most;
}

}  // namespace talus
