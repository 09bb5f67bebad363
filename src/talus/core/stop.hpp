#pragma once
// Long work that ends early on request: whoever begins it says what ends it, and the work asks at places where it can
// be left without harm.

#include <atomic>
#include <chrono>
#include <cstddef>

namespace talus {

/// Thrown where work is left. No std::exception: nothing has failed, and only who asked for the work catches it.
struct Stopped {};

/// Null: nobody can ask.
[[nodiscard]] inline bool is_requested(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

/// How long work may take: a time by the clock, but no less than the same time of the processor, so that a machine that
/// is busy otherwise does not cut it short; thirty times as long by the clock in any case.
class TimeLimit {
 public:
  /// From now on.
  explicit TimeLimit(std::chrono::duration<double> limit);
  [[nodiscard]] bool is_over() const;

 private:
  std::chrono::duration<double> limit_;
  std::chrono::steady_clock::time_point begin_;
  double processor_begin_;  // [s] of this process
};

/// While it lives, stop_point() in this thread throws Stopped once the scope, or one around it, is asked to end.
class StopScope {
 public:
  /// Null: nothing of its own.
  explicit StopScope(const std::atomic<bool>* stop, const TimeLimit* limit = nullptr);
  /// In a thread that does a part of the work of another one, whose scope is `of` and outlives this; null: none.
  explicit StopScope(const StopScope* of);
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;
  ~StopScope();

  /// The innermost of this thread; null: none.
  [[nodiscard]] static const StopScope* current();
  [[nodiscard]] bool is_requested() const;

 private:
  const std::atomic<bool>* stop_ = nullptr;
  const TimeLimit* limit_ = nullptr;
  const StopScope* around_;
  const StopScope* before_;  // of this thread
};

/// A place where work can be left. Costs next to nothing: to be passed some hundred times a second at the least.
void stop_point();

/// The same in a loop of short steps: looks at the first and every 1024th.
inline void stop_point(std::size_t step) {
  constexpr std::size_t steps = 1024;
  if (step % steps == 0) stop_point();
}

}  // namespace talus
