#pragma once
// Server-sent events (HTML Living Standard, section 9.2).

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "http/answer.hpp"

namespace talus::server {

class EventHub;

/// One client. Events wait here until they are sent, only the last one per key, so that a slow reader costs no memory.
class Listener {
 public:
  explicit Listener(EventHub& hub) : hub_(hub) {}

  /// Waits for events for at most a second and returns the text to send: empty if there is nothing to send, nullopt
  /// once the hub is closed.
  [[nodiscard]] std::optional<std::string> next();

 private:
  friend class EventHub;
  using Clock = std::chrono::steady_clock;

  EventHub& hub_;
  std::vector<std::pair<std::string, std::string>> waiting_;  // key and text of each event
  Clock::time_point sent_events_{};                           // when events were sent last
  Clock::time_point sent_{};                                  // when anything was sent last, comments included
};

class EventHub {
 public:
  /// Each listener holds a thread of the server.
  static constexpr std::size_t most_listeners = 32;

  /// Refuses (503) if there are too many listeners. The hub must outlive the listener.
  [[nodiscard]] std::shared_ptr<Listener> listen();
  /// Sends an event to all listeners. It replaces earlier events of the same key that have not been sent yet.
  void publish(std::string_view event, const std::string& key, const Json& data);
  /// Ends all listeners, present and future.
  void close();

 private:
  friend class Listener;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::weak_ptr<Listener>> listeners_;
  bool is_closed_ = false;
};

}  // namespace talus::server
