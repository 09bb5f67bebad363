#pragma once
// Long work that can be stopped on request: the caller sets up the condition, and the work checks it where it can end
// without harm.

#include <atomic>
#include <chrono>
#include <cstddef>

namespace talus {

/// Thrown to end stopped work. Not a std::exception: nothing has failed, and only the caller that set up the condition
/// catches it.
struct Stopped {};

/// Null: never.
[[nodiscard]] inline bool is_requested(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

/// A limit on the time of work: it is over when both the clock and the processor time of this process have reached it,
/// so that a busy machine does not end the work early; or after thirty times the limit by the clock.
class TimeLimit {
 public:
  /// Starts now.
  explicit TimeLimit(std::chrono::duration<double> limit);
  [[nodiscard]] bool is_over() const;

 private:
  std::chrono::duration<double> limit_;
  std::chrono::steady_clock::time_point begin_;
  double processor_begin_;  // [s] of this process
};

/// During its lifetime, stop_point() in this thread throws Stopped once a stop is requested of it or of a scope around
/// it.
class StopScope {
 public:
  /// Null: no condition of its own.
  explicit StopScope(const std::atomic<bool>* stop, const TimeLimit* limit = nullptr);
  /// In a thread that does part of the work of another, whose scope `of` outlives this one; null: no scope.
  explicit StopScope(const StopScope* of);
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;
  ~StopScope();

  /// The innermost scope of this thread; null if there is none.
  [[nodiscard]] static const StopScope* current();
  [[nodiscard]] bool is_requested() const;

 private:
  const std::atomic<bool>* stop_ = nullptr;
  const TimeLimit* limit_ = nullptr;
  const StopScope* around_;
  const StopScope* before_;  // of this thread
};

/// A place where work can be stopped. Costs almost nothing; to be called at least some hundred times per second.
void stop_point();

/// The same in a loop of short steps: checks at the first and at every 1024th step.
inline void stop_point(std::size_t step) {
  constexpr std::size_t steps = 1024;
  if (step % steps == 0) stop_point();
}

}  // namespace talus
