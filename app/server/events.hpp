#pragma once
// What happens, told to all who listen: server-sent events (HTML Living Standard, section 9.2).

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

/// One who listens. News wait here until they are fetched: of each thing only the last, so that a slow reader costs no
/// memory.
class Listener {
 public:
  explicit Listener(EventHub& hub) : hub_(hub) {}

  /// The text to send next, waiting for a second at most. Empty: nothing has happened. Nothing: it is over.
  [[nodiscard]] std::optional<std::string> next();

 private:
  friend class EventHub;
  using Clock = std::chrono::steady_clock;

  EventHub& hub_;
  std::vector<std::pair<std::string, std::string>> waiting_;  // of which thing, and the event's text
  Clock::time_point sent_{};                                  // the last events
  Clock::time_point spoke_{};                                 // the last word, or comment
};

class EventHub {
 public:
  /// No more than this listen at a time: each holds a thread of the server.
  static constexpr std::size_t most_listeners = 32;

  /// Refuses (503) where too many listen. The hub must outlive the listener.
  [[nodiscard]] std::shared_ptr<Listener> listen();
  /// An event about a thing, of which only the last matters to those who have not heard of the ones before.
  void publish(std::string_view event, const std::string& thing, const Json& data);
  /// Ends all listening, now and later.
  void close();

 private:
  friend class Listener;

  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::weak_ptr<Listener>> listeners_;
  bool is_closed_ = false;
};

}  // namespace talus::server
