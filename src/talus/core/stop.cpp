#include "talus/core/stop.hpp"

#include <ctime>

namespace talus {

namespace {

thread_local const StopScope* innermost = nullptr;

double processor_seconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

}  // namespace

TimeLimit::TimeLimit(std::chrono::duration<double> limit)
    : limit_(limit), begin_(std::chrono::steady_clock::now()), processor_begin_(processor_seconds()) {}

bool TimeLimit::is_over() const {
  const auto elapsed = std::chrono::steady_clock::now() - begin_;
  if (elapsed < limit_) return false;
  return elapsed >= 30 * limit_ || processor_seconds() - processor_begin_ >= limit_.count();
}

StopScope::StopScope(const std::atomic<bool>* stop, const TimeLimit* limit)
    : stop_(stop), limit_(limit), around_(innermost), before_(innermost) {
  innermost = this;
}

StopScope::StopScope(const StopScope* of) : around_(of), before_(innermost) { innermost = this; }

StopScope::~StopScope() { innermost = before_; }

const StopScope* StopScope::current() { return innermost; }

bool StopScope::is_requested() const {
  for (const StopScope* scope = this; scope != nullptr; scope = scope->around_) {
    if (talus::is_requested(scope->stop_) || (scope->limit_ != nullptr && scope->limit_->is_over())) return true;
  }
  return false;
}

void stop_point() {
  if (innermost != nullptr && innermost->is_requested()) throw Stopped{};
}

}  // namespace talus
