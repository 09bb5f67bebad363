#pragma once
// Reads models in separate threads: a file may be on a drive that does not respond, and a thread that waits for the
// system cannot be ended. Callers can stop waiting at any time. A read without callers ends at its next stop point, or
// its thread is abandoned.

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace talus::server {

class ModelReading {
 public:
  /// `longest`: the time limit for a model.
  explicit ModelReading(std::chrono::milliseconds longest);

  /// Calls `read` in a separate thread and returns its result. Concurrent callers with the same `key` (not empty) share
  /// one read. `read` must own what it needs. Only few reads start at a time, since models are large, but a slow one
  /// does not block the next. Throws what `read` throws; Stopped if the caller's StopScope asks for it; BadInput after
  /// the time limit; Refusal (503) if too many threads are abandoned.
  template <class Result>
  std::shared_ptr<const Result> read(const std::string& key, std::function<Result()> read) {
    return std::static_pointer_cast<const Result>(
        wait_for(key, [read = std::move(read)] { return std::make_shared<const Result>(read()); }));
  }

  /// Number of threads that are still reading. While there are some the program must not end normally, by destroying
  /// static objects.
  [[nodiscard]] std::size_t threads() const;

 private:
  using Work = std::function<std::shared_ptr<const void>()>;
  struct Job;
  struct State;

  std::shared_ptr<const void> wait_for(const std::string& key, Work work);

  std::chrono::milliseconds longest_;
  std::shared_ptr<State> state_;  // shared with the threads
};

}  // namespace talus::server
