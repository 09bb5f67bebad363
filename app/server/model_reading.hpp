#pragma once
// Models are read in threads of their own: a file may lie where nothing answers, and a thread that the system keeps
// waiting cannot be ended. Whoever waits for a model can leave; what is read then for nobody ends at its next stop
// point, or keeps its thread.

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace talus::server {

class ModelReading {
 public:
  /// `longest`: how long a model may take.
  explicit ModelReading(std::chrono::milliseconds longest);

  /// What `read` gives, in a thread of its own; of several who ask for the same `key` (not empty) at a time one reads
  /// for all. `read` must own what it needs. Few read at a time, since models are large; one that takes long keeps
  /// nobody waiting. Throws what `read` throws; Stopped at the request of the caller's StopScope; BadInput where it
  /// takes too long; Refusal (503) where too many do not end.
  template <class Result>
  std::shared_ptr<const Result> read(const std::string& key, std::function<Result()> read) {
    return std::static_pointer_cast<const Result>(
        wait_for(key, [read = std::move(read)] { return std::make_shared<const Result>(read()); }));
  }

  /// Threads that still read for nobody: as long as there are some, the program must not end in the ordinary way.
  [[nodiscard]] std::size_t left_alone() const;

 private:
  using Work = std::function<std::shared_ptr<const void>()>;
  struct Job;
  struct State;

  std::shared_ptr<const void> wait_for(const std::string& key, Work work);

  std::chrono::milliseconds longest_;
  std::shared_ptr<State> state_;  // the threads' too
};

}  // namespace talus::server
