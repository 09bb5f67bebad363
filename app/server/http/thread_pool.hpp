#pragma once
// Threads that answer requests, one per request in progress, since a client may pause for seconds or read slowly.

#include <httplib.h>
#undef _res  // a macro of the resolver's header, and a name in Eigen's

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace talus::server {

class ThreadPool : public httplib::TaskQueue {
 public:
  /// Starts threads when they are needed, `most` at most.
  explicit ThreadPool(std::size_t most) : most_(most) {}

  void enqueue(std::function<void()> work) override;
  /// Finishes all queued work first.
  void shutdown() override;

 private:
  void take_work();

  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  std::vector<std::thread> threads_;
  std::size_t idle_ = 0;
  bool ends_ = false;
};

}  // namespace talus::server
