#include "events.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::server {

namespace {

using namespace std::chrono_literals;

constexpr auto between_events = 100ms;
constexpr auto between_comments = 10s;  // proxies may close an idle connection
constexpr auto longest_wait = 1s;       // for checking whether the client is still connected

}  // namespace

std::optional<std::string> Listener::next() {
  std::unique_lock lock(hub_.mutex_);
  const auto now = [] { return Clock::now(); };
  if (sent_ == Clock::time_point{}) {
    sent_ = now();
    return ": talus\nretry: 1000\n\n";
  }
  hub_.changed_.wait_until(lock, sent_events_ + between_events, [&] { return hub_.is_closed_; });
  hub_.changed_.wait_for(lock, longest_wait, [&] { return hub_.is_closed_ || !waiting_.empty(); });
  if (hub_.is_closed_) return std::nullopt;
  std::string text;
  if (!waiting_.empty()) {
    for (const auto& [key, event] : waiting_) text += event;
    waiting_.clear();
    sent_events_ = now();
  } else if (now() - sent_ >= between_comments) {
    text = ":\n\n";
  }
  if (!text.empty()) sent_ = now();
  return text;
}

std::shared_ptr<Listener> EventHub::listen() {
  const std::lock_guard lock(mutex_);
  std::erase_if(listeners_, [](const auto& listener) { return listener.expired(); });
  if (listeners_.size() >= most_listeners)
    throw Refusal(503, "events", "there are too many listeners", fmt::format("at most {} are allowed", most_listeners),
                  "Close other pages of the workbench");
  auto listener = std::make_shared<Listener>(*this);
  listeners_.push_back(listener);
  return listener;
}

void EventHub::publish(std::string_view event, const std::string& key, const Json& data) {
  // The format requires one line; JSON writes the line ends of texts as \n.
  const std::string text =
      fmt::format("event: {}\ndata: {}\n\n", event, data.dump(-1, ' ', false, Json::error_handler_t::replace));
  const std::lock_guard lock(mutex_);
  for (const auto& weak : listeners_) {
    const auto listener = weak.lock();
    if (!listener) continue;
    auto& waiting = listener->waiting_;
    std::erase_if(waiting, [&](const auto& other) { return other.first == key; });
    waiting.emplace_back(key, text);
  }
  changed_.notify_all();
}

void EventHub::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
}

}  // namespace talus::server
