// Server-sent events about runs.

#include "server/served_runs.hpp"

#include <chrono>
#include <mutex>

#include "events.hpp"

namespace talus {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using testing_tools::Json;
using testing_tools::ServedRuns;

struct Event {
  std::string name;
  Json data;
  Clock::time_point time;
};

/// A client that receives events in its own thread.
class EventClient {
 public:
  EventClient(int port, const std::string& cookie)
      : client_("127.0.0.1", port), thread_([this, cookie] {
          const auto answer =
              client_.Get("/api/events", {{"Cookie", cookie}}, [this](const char* data, std::size_t size) {
                receive(std::string(data, size));
                return !is_closing_;
              });
          const std::lock_guard lock(mutex_);
          status_ = answer ? answer->status : 0;
          has_ended_ = true;
        }) {
    client_.set_read_timeout(60, 0);
  }
  ~EventClient() {
    is_closing_ = true;
    client_.stop();
    thread_.join();
  }

  [[nodiscard]] std::vector<Event> events() {
    const std::lock_guard lock(mutex_);
    return events_;
  }
  [[nodiscard]] std::string text() {
    const std::lock_guard lock(mutex_);
    return text_;
  }
  [[nodiscard]] bool has_ended() {
    const std::lock_guard lock(mutex_);
    return has_ended_;
  }
  /// Waits until the condition is true; false after a minute.
  bool wait(const std::function<bool()>& condition) const {
    const auto end = Clock::now() + 60s;
    while (!condition() && Clock::now() < end) std::this_thread::sleep_for(2ms);
    return condition();
  }
  /// Waits for an event with this value.
  bool receives(const std::string& name, const std::string& key, const std::string& value) {
    return wait([&] {
      for (const Event& event : events())
        if (event.name == name && event.data.value(key, "") == value) return true;
      return false;
    });
  }
  bool has_begun() {
    return wait([&] { return !text().empty(); });
  }

 private:
  void receive(const std::string& part) {
    const std::lock_guard lock(mutex_);
    text_ += part;
    for (std::size_t end = text_.find("\n\n", read_); end != std::string::npos; end = text_.find("\n\n", read_)) {
      const std::string block = text_.substr(read_, end - read_);
      read_ = end + 2;
      const std::size_t data = block.find("\ndata: ");
      if (!block.starts_with("event: ") || data == std::string::npos) continue;
      events_.push_back({block.substr(7, data - 7), Json::parse(block.substr(data + 7)), Clock::now()});
    }
  }

  httplib::Client client_;
  std::mutex mutex_;
  std::string text_;
  std::size_t read_ = 0;
  std::vector<Event> events_;
  std::atomic<bool> is_closing_{false};
  bool has_ended_ = false;
  int status_ = 0;
  std::thread thread_;
};

using Events = ServedRuns;

TEST_F(Events, ReportARunFromBeginningToEnd) {
  EventClient client(port_, cookie_);
  ASSERT_TRUE(client.has_begun());
  const std::string id = begin(section(), {{"rocks", 60'000}, {"name", "<b>\\n</b>"}});
  ASSERT_TRUE(client.receives("run", "state", "done"));
  const auto events = client.events();
  std::uint64_t done = 0;
  for (const Event& event : events) {
    EXPECT_EQ(event.name, "run");
    EXPECT_EQ(event.data["id"], id);
    EXPECT_EQ(event.data["name"], "<b>\\n</b>");
    EXPECT_GE(event.data["done"], done);
    done = event.data["done"];
  }
  EXPECT_EQ(done, 60'000U);
  EXPECT_EQ(events.back().data, run(id));
  EXPECT_EQ(send("DELETE", "/api/runs/" + id).status, 200);
  EXPECT_TRUE(client.receives("removed", "id", id));
}

TEST_F(Events, ComeAtMostTenTimesASecond) {
  EventClient client(port_, cookie_);
  ASSERT_TRUE(client.has_begun());
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  ASSERT_TRUE(client.wait([&] { return client.events().size() >= 8; }));
  (void)ask(id, "stop");
  const auto events = client.events();
  // Events of one run are sent 100 ms apart: 700 ms from the first to the eighth, less delays of the client's clock.
  EXPECT_GE(events[7].time - events[0].time, 600ms);
  const Json& last = events[7].data;
  EXPECT_EQ(last["state"], "running");
  EXPECT_GT(last["rate"], 0);
  EXPECT_GT(last["seconds_left"], 0);
}

TEST_F(Events, EndWithTheServer) {
  EventClient client(port_, cookie_);
  ASSERT_TRUE(client.has_begun());
  const auto begin = Clock::now();
  stop();
  EXPECT_LT(Clock::now() - begin, 10s);
  EXPECT_TRUE(client.wait([&] { return client.has_ended(); }));
}

TEST_F(Events, RequireASession) { EXPECT_EQ(send("GET", "/api/events", "", {{"Cookie", "nothing"}}).status, 403); }

/// A connection that requests events but reads none.
int unread_connection(int port, const std::string& cookie) {
  const int made = testing_tools::connect_to_loopback(port);
  EXPECT_GE(made, 0);
  const std::string request =
      "GET /api/events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\nCookie: " + cookie + "\r\n\r\n";
  EXPECT_EQ(write(made, request.data(), request.size()), static_cast<ssize_t>(request.size()));
  std::array<char, 12> status{};
  EXPECT_EQ(recv(made, status.data(), status.size(), MSG_WAITALL), 12);
  return made;
}

// A disconnected client must not count as a listener, nor hold a thread.
TEST_F(Events, ForgetDisconnectedClients) {
  std::vector<int> connections;
  for (std::size_t k = 0; k < server::EventHub::most_listeners; ++k)
    connections.push_back(unread_connection(port_, cookie_));
  EXPECT_EQ(get("/api/events").status, 503);
  EXPECT_EQ(get("/api/about").status, 200);
  for (const int each : connections) close(each);
  const auto end = Clock::now() + 30s;
  bool has_place = false;
  while (!has_place && Clock::now() < end) {
    const int next = unread_connection(port_, cookie_);
    close(next);
    EventClient client(port_, cookie_);
    has_place = client.wait([&] { return client.has_ended() || !client.text().empty(); }) &&
                client.text().starts_with(": talus");
  }
  EXPECT_TRUE(has_place);
}

// If events are published faster than they are read, only the last one per key is kept.
TEST(EventHub, KeepsTheLastEventOfEachKey) {
  server::EventHub hub;
  const auto listener = hub.listen();
  ASSERT_TRUE(listener->next());
  for (int k = 0; k < 100'000; ++k) hub.publish("run", k % 2 == 0 ? "a" : "b", {{"k", k}});
  hub.publish("removed", "a", {{"id", "a"}});
  const auto text = listener->next();
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "event: run\ndata: {\"k\":99999}\n\nevent: removed\ndata: {\"id\":\"a\"}\n\n");
  hub.close();
  EXPECT_FALSE(listener->next());
}

}  // namespace
}  // namespace talus
