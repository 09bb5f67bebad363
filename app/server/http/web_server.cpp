#include "http/web_server.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <system_error>

#include "talus/core/stop.hpp"

namespace talus::server {

namespace {

using namespace std::chrono_literals;

/// The library's task queue for accepted connections: process_and_close_socket() is quick, so that no thread is needed.
class Immediately : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> work) override { work(); }
  void shutdown() override {}
};

constexpr std::string_view too_large =
    "HTTP/1.1 431 Request Header Fields Too Large\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";

}  // namespace

WebServer::WebServer(const Limits& limits, std::size_t most_threads)
    : limits_(limits), answering_(most_threads), wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  new_task_queue = [] { return new Immediately; };
  watching_ = std::thread([this] { watch(); });
}

WebServer::~WebServer() {
  end_connections();
  wait();
  close(wake_);
}

void WebServer::wait() {
  if (!watching_.joinable()) return;
  watching_.join();
  answering_.shutdown();
}

void WebServer::end_connections() {
  is_closed_ = true;
  const std::lock_guard lock(mutex_);
  for (const Held& connection : busy_) connection->end();
  wake();
}

void WebServer::wake() const {
  const std::uint64_t one = 1;
  (void)!::write(wake_, &one, sizeof one);
}

bool WebServer::process_and_close_socket(socket_t socket) {
  const std::lock_guard lock(mutex_);
  arrived_.push_back(std::make_shared<Connection>(socket, limits_));
  wake();
  return true;
}

void WebServer::dispatch(std::vector<Held>& idle, const Held& connection, Connection::Head head) {
  switch (head) {
    case Connection::Head::incomplete:  // new bytes do not extend the deadline
      if (Connection::Clock::now() < connection->deadline()) idle.push_back(connection);
      return;
    case Connection::Head::closed:
      return;
    case Connection::Head::too_large:
      (void)!send(connection->descriptor(), too_large.data(), too_large.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      return;
    case Connection::Head::complete: {
      {
        const std::lock_guard lock(mutex_);
        busy_.insert(connection);
      }
      try {
        answering_.enqueue([this, connection] { answer(connection); });
      } catch (const std::system_error&) {  // the system allows no thread at all: the client may try again
        const std::lock_guard lock(mutex_);
        busy_.erase(connection);
      }
    }
  }
}

void WebServer::watch() {
  std::vector<Held> idle, previous, busy, arrived;  // idle ones by age
  std::vector<pollfd> polled;
  while (!is_closed_) {
    busy.clear();
    {
      const std::lock_guard lock(mutex_);
      arrived.swap(arrived_);
      busy.assign(busy_.begin(), busy_.end());
    }
    for (const Held& connection : arrived) {
      const Connection::Head head = connection->head();
      dispatch(idle, connection, head == Connection::Head::incomplete ? connection->receive() : head);
    }
    arrived.clear();
    if (idle.size() > limits_.idle_connections)
      idle.erase(idle.begin(), idle.end() - static_cast<std::ptrdiff_t>(limits_.idle_connections));

    polled.assign(1, {.fd = wake_, .events = POLLIN, .revents = 0});
    for (const Held& each : idle) polled.push_back({.fd = each->descriptor(), .events = POLLIN, .revents = 0});
    for (const Held& each : busy) {
      if (!each->has_gone) polled.push_back({.fd = each->descriptor(), .events = POLLRDHUP, .revents = 0});
    }
    constexpr int interval = 250;  // [ms]: for checking deadlines
    if (poll(polled.data(), polled.size(), interval) < 0) continue;
    std::uint64_t ignored = 0;
    (void)!read(wake_, &ignored, sizeof ignored);

    previous.swap(idle);
    idle.clear();
    for (std::size_t k = 0; k < previous.size(); ++k) {
      const bool has_bytes = polled[1 + k].revents != 0;
      dispatch(idle, previous[k], has_bytes ? previous[k]->receive() : Connection::Head::incomplete);
    }
    std::size_t at = 1 + previous.size();
    previous.clear();
    for (const Held& each : busy) {
      if (!each->has_gone && polled[at++].revents != 0) each->has_gone = true;
    }
  }
}

void WebServer::answer(const Held& connection) {
  bool is_over = false, is_answered = false;
  {
    const StopScope ending(&is_closed_), leaving(&connection->has_gone);
    try {
      // apply_range() cuts answers, not the library.
      is_answered =
          process_request(*connection, false, is_over, [](httplib::Request& request) { request.ranges.clear(); });
    } catch (...) {  // a failure while the answer is sent cannot be reported to the client
      is_answered = false;
    }
  }
  const std::lock_guard lock(mutex_);
  busy_.erase(connection);
  if (is_answered && !is_over && !is_closed_) {
    connection->begin_next();
    arrived_.push_back(connection);
  } else {
    connection->end();
  }
  wake();
}

}  // namespace talus::server
