#pragma once
// One connection of a client. What it has sent of its next request is gathered without a thread that waits for it.

#include <httplib.h>
#undef _res  // a macro of the resolver's header, and a name in Eigen's

#include <atomic>
#include <chrono>
#include <string>

#include "http/limits.hpp"

namespace talus::server {

/// A stream of the library over a socket that this owns.
class Connection : public httplib::Stream {
 public:
  using Clock = std::chrono::steady_clock;

  Connection(socket_t socket, const Limits& limits) : socket_(socket), limits_(limits) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() override;

  /// What has come of the next request's head.
  enum class Head { incomplete, complete, too_large, closed };
  /// Takes what is there, without waiting.
  Head gather();
  /// The same of what was taken before, with the end of the request before it.
  [[nodiscard]] Head head() const;
  /// When it is to be closed if nothing more comes.
  [[nodiscard]] Clock::time_point deadline() const;
  /// The request is answered: what follows is the next one.
  void begin_next();

  /// Set once the client has gone, by whoever watches the socket.
  std::atomic<bool> has_gone{false};
  /// No byte more is read or written. By any thread.
  void end() const;
  [[nodiscard]] socket_t descriptor() const { return socket_; }

  // What the library asks of a stream, in the thread that answers the request.
  /// It asks only whether select() would take the number; here nobody selects.
  [[nodiscard]] socket_t socket() const override { return 0; }
  [[nodiscard]] bool is_readable() const override;
  [[nodiscard]] bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  using httplib::Stream::write;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;

 private:
  [[nodiscard]] bool is_ready(short events, std::chrono::milliseconds patience) const;

  socket_t socket_;
  const Limits& limits_;
  std::string arrived_;    // and not taken by a request
  std::size_t taken_ = 0;  // of it
  Clock::time_point silent_since_ = Clock::now(), head_since_{};
};

}  // namespace talus::server
