#include "talus/core/memory_reserve.hpp"

#include <atomic>
#include <cstdlib>

namespace talus {

namespace {

// Enough to write a checkpoint, or to unwind and print a message; less, if there is no more. It is never written to: it
// costs address space, not memory.
constexpr std::size_t most_bytes = std::size_t{64} << 20, least_bytes = std::size_t{1} << 20;

std::atomic<void*> reserve{nullptr};
std::atomic<bool> is_short{false};

/// Called by any thread when operator new fails: it tries again if this returns.
void use_reserve() {
  is_short = true;
  void* const kept = reserve.exchange(nullptr);
  if (kept == nullptr) throw std::bad_alloc();
  std::free(kept);
}

}  // namespace

void keep_memory_reserve() {
  is_short = false;
  if (reserve.load() == nullptr) {
    void* kept = nullptr;
    for (std::size_t bytes = most_bytes; kept == nullptr && bytes >= least_bytes; bytes /= 2) kept = std::malloc(bytes);
    void* none = nullptr;
    if (!reserve.compare_exchange_strong(none, kept)) std::free(kept);
  }
  std::set_new_handler(&use_reserve);
}

bool memory_is_short() { return is_short; }

}  // namespace talus
