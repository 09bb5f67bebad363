#include "talus/campaign/thread_supply.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstddef>
#include <future>
#include <new>
#include <thread>
#include <vector>

#include "talus/campaign/campaign.hpp"
#include "talus/core/problems.hpp"

namespace talus {

ThreadSupply try_threads(int requested) {
  ThreadSupply supply;
  std::promise<void> all_are_there;
  const std::shared_future<void> end = all_are_there.get_future().share();
  std::vector<std::thread> others;
  try {
    while (supply.threads < threads_for(requested)) {
      others.emplace_back([end] { end.wait(); });
      ++supply.threads;
    }
  } catch (const std::system_error& error) {
    supply.why = error.code();
  }
  all_are_there.set_value();
  for (std::thread& other : others) other.join();
  return supply;
}

void limit_threads(int most) {
  using Limit = tbb::global_control;
  // Never destroyed: TBB would then request the other threads at once, and terminate the program if it got none.
  alignas(Limit) static std::byte place[sizeof(Limit)];
  static const auto* const limit = ::new (place) Limit(Limit::max_allowed_parallelism, static_cast<std::size_t>(most));
  (void)limit;
}

void take_threads(int requested) {
  const ThreadSupply supply = try_threads(requested);
  if (supply.why) {
    throw BadInput(Problem{.where = "--threads",
                           .what = fmt::format("{} threads are not available", threads_for(requested)),
                           .why = supply.why.message(),
                           .hint = fmt::format("Try --threads {}", supply.threads)});
  }
  limit_threads(supply.threads);
}

void take_available_threads() { limit_threads(try_threads(0).threads); }

}  // namespace talus
