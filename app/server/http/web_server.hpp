#pragma once
// The library's server with its own handling of connections: a request gets a thread once its head is complete, so that
// idle and slow clients cost no more than a socket.

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "http/connection.hpp"
#include "http/thread_pool.hpp"

namespace talus::server {

class WebServer : public httplib::Server {
 public:
  /// Requests are answered by at most `most_threads` threads.
  WebServer(const Limits& limits, std::size_t most_threads);
  ~WebServer() override;

  /// Ends all connections, present and future. Requests in progress read and write no more, and their StopScope is
  /// asked to stop.
  void end_connections();
  /// Call after end_connections(). Waits until no request is in progress.
  void wait();

 private:
  using Held = std::shared_ptr<Connection>;

  /// Called by the thread that accepts connections.
  bool process_and_close_socket(socket_t socket) override;
  /// The loop of the thread that polls all connections.
  void watch();
  /// Starts the answer if the head is complete; an incomplete connection is added to `idle`, others are dropped.
  void dispatch(std::vector<Held>& idle, const Held& connection, Connection::Head head);
  void answer(const Held& connection);
  /// Interrupts the poll of watch().
  void wake() const;

  const Limits limits_;
  ThreadPool answering_;
  std::atomic<bool> is_closed_{false};
  int wake_;  // an eventfd
  std::mutex mutex_;
  std::vector<Held> arrived_;  // new connections, and those whose request was answered
  std::set<Held> busy_;        // connections whose request is being answered
  std::thread watching_;
};

}  // namespace talus::server
