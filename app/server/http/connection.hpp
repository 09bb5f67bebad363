#pragma once
// One connection of a client. The head of its next request is received without a waiting thread.

#include <httplib.h>
#undef _res  // a macro of the resolver's header, and a name in Eigen's

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "http/limits.hpp"

namespace talus::server {

/// A stream of the library that owns its socket.
class Connection : public httplib::Stream {
 public:
  using Clock = std::chrono::steady_clock;

  Connection(socket_t socket, const Limits& limits) : socket_(socket), limits_(limits) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() override;

  /// State of the next request's head.
  enum class Head { incomplete, complete, too_large, closed };
  /// Receives available bytes without waiting.
  Head receive();
  /// State of the bytes received so far: some may have come together with the request before.
  [[nodiscard]] Head head() const;
  /// When the connection is closed if the head is still incomplete.
  [[nodiscard]] Clock::time_point deadline() const;
  /// The request is answered: the following bytes are the next one.
  void begin_next();

  /// The client has disconnected. Set by the thread that polls the socket.
  std::atomic<bool> has_gone{false};
  /// Ends reading and writing. May be called by any thread.
  void end() const;
  [[nodiscard]] socket_t descriptor() const { return socket_; }

  // The library's interface of a stream, called by the thread that answers the request.
  /// The library only checks that the number is valid for select(), which is not used here.
  [[nodiscard]] socket_t socket() const override { return 0; }
  [[nodiscard]] bool is_readable() const override;
  [[nodiscard]] bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  using httplib::Stream::write;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;

 private:
  void drop_empty_lines();
  [[nodiscard]] bool is_ready(short events, std::chrono::milliseconds patience) const;

  socket_t socket_;
  const Limits& limits_;
  std::string received_;  // from the first line of the current request, without empty lines before it
  std::size_t read_ = 0;  // bytes of it that the library has read
  Clock::time_point idle_since_ = Clock::now();
  std::optional<Clock::time_point> head_since_;  // nullopt: no byte of the next request has arrived
};

}  // namespace talus::server
