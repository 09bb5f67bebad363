#include "http/connection.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace talus::server {

namespace {

using namespace std::chrono_literals;

constexpr auto patience_with_bodies = 5s, patience_with_readers = 30s;  // for the next byte

}  // namespace

Connection::~Connection() {
  end();
  close(socket_);
}

void Connection::end() const { shutdown(socket_, SHUT_RDWR); }

Connection::Head Connection::head() const {
  const std::string_view unread = std::string_view(received_).substr(read_);
  // The library reads a head up to the first empty line, whatever precedes it.
  const std::size_t end = unread.find("\r\n\r\n");
  const std::size_t bytes = end == std::string_view::npos ? unread.size() : end;
  if (bytes > limits_.head_bytes) return Head::too_large;
  return end == std::string_view::npos ? Head::incomplete : Head::complete;
}

Connection::Head Connection::receive() {
  std::array<char, 4096> bytes;
  for (;;) {
    const ssize_t got = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return Head::incomplete;
    if (got <= 0) return Head::closed;
    if (!head_since_) head_since_ = Clock::now();
    received_.append(bytes.data(), static_cast<std::size_t>(got));
    drop_empty_lines();
    if (const Head now = head(); now != Head::incomplete) return now;
  }
}

Connection::Clock::time_point Connection::deadline() const {
  return head_since_ ? *head_since_ + limits_.head_time : idle_since_ + limits_.idle_time;
}

// A server ignores empty lines before a request (RFC 9112, 2.2). The library would answer each as a request.
void Connection::drop_empty_lines() { received_.erase(0, received_.find_first_not_of("\r\n")); }

void Connection::begin_next() {
  received_.erase(0, read_);
  read_ = 0;
  idle_since_ = Clock::now();
  head_since_ = received_.empty() ? std::nullopt : std::optional(idle_since_);
  drop_empty_lines();
}

bool Connection::is_ready(short events, std::chrono::milliseconds patience) const {
  pollfd waiting{.fd = socket_, .events = events, .revents = 0};
  int found = 0;
  do {
    found = poll(&waiting, 1, static_cast<int>(patience.count()));
  } while (found < 0 && errno == EINTR);
  return found > 0 && (waiting.revents & events) != 0;
}

bool Connection::is_readable() const { return read_ < received_.size() || is_ready(POLLIN, patience_with_bodies); }

bool Connection::is_writable() const { return !has_gone && is_ready(POLLOUT, patience_with_readers); }

ssize_t Connection::read(char* to, std::size_t size) {
  if (read_ < received_.size()) {
    const std::size_t count = std::min(size, received_.size() - read_);
    std::memcpy(to, received_.data() + read_, count);
    read_ += count;
    return static_cast<ssize_t>(count);
  }
  if (!is_ready(POLLIN, patience_with_bodies)) return -1;
  return recv(socket_, to, size, MSG_DONTWAIT);
}

ssize_t Connection::write(const char* from, std::size_t size) {
  for (;;) {
    const ssize_t sent = send(socket_, from, size, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent >= 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) return sent;
    if (errno != EINTR && !is_ready(POLLOUT, patience_with_readers)) return -1;
  }
}

void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip = "127.0.0.1";  // the only address on which the server listens
  port = -1;
}
void Connection::get_local_ip_and_port(std::string& ip, int& port) const { get_remote_ip_and_port(ip, port); }

}  // namespace talus::server
