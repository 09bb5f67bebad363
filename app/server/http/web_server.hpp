#pragma once
// The library's server, with other connections: a request gets a thread once its head is there, so that whoever says
// nothing, or says it byte by byte, costs no more than a socket.

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
  /// Requests are answered by so many threads at most.
  WebServer(const Limits& limits, std::size_t most_threads);
  ~WebServer() override;

  /// Ends all connections, now and later: of requests under way nothing more is read or written, and their StopScope is
  /// asked to end.
  void end_connections();
  /// Until no request is under way, after that.
  void wait();

 private:
  using Held = std::shared_ptr<Connection>;

  /// Called by the thread that accepts connections.
  bool process_and_close_socket(socket_t socket) override;
  void watch();
  void look_at(std::vector<Held>& silent, const Held& connection, Connection::Head head);
  void answer(const Held& connection);
  void wake() const;

  const Limits limits_;
  ThreadPool answering_;
  std::atomic<bool> is_closed_{false};
  int wake_;  // an eventfd
  std::mutex mutex_;
  std::vector<Held> come_;   // new ones, and those whose request was answered
  std::set<Held> answered_;  // whose request is being answered
  std::thread watching_;
};

}  // namespace talus::server
