// Start and end of the server.

#include "server/served.hpp"

#include <future>

#include "talus/core/problems.hpp"

namespace talus {
namespace {

using testing_tools::Served;

class Serving : public Served {
 protected:
  /// Options of another server for the same folder.
  [[nodiscard]] server::ServeOptions second_server() const {
    server::ServeOptions options = options_;
    options.port = 0;
    options.ready = nullptr;
    return options;
  }
};

/// The reason why the server does not start.
std::string refusal(server::ServeOptions options) {
  const std::atomic<bool> stop{true};
  options.stop = &stop;
  options.ready = nullptr;
  try {
    server::serve(options);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "serves";
}

TEST_F(Serving, NeedsAFreePort) {
  server::ServeOptions other = options_;
  other.port = port_;
  EXPECT_EQ(refusal(other), "--port: cannot listen on port " + std::to_string(port_) +
                                " (another program uses it, perhaps another `talus serve`). Choose another port, or 0 "
                                "for any free one");
  EXPECT_EQ(get("/api/about").status, 200);
}

TEST_F(Serving, NeedsAFolder) {
  server::ServeOptions other = second_server();
  other.folder = path("none");
  EXPECT_EQ(refusal(other), path("none").string() + ": is not a folder");
}

TEST_F(Serving, EndsWhenItIsStoppedBeforeItListens) {
  static std::atomic<bool> stop;
  stop = false;
  server::ServeOptions other = second_server();
  other.stop = &stop;
  other.ready = [](const std::string&) {
    stop = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  };
  std::packaged_task<void()> serving([other] { server::serve(other); });
  const auto end = serving.get_future();
  std::thread(std::move(serving)).detach();
  EXPECT_EQ(end.wait_for(std::chrono::seconds(30)), std::future_status::ready);
}

TEST_F(Serving, EndsIfItsAddressCannotBeReported) {
  const std::atomic<bool> stop{false};
  server::ServeOptions other = second_server();
  other.stop = &stop;
  other.ready = [](const std::string&) { throw std::runtime_error("not reported"); };
  EXPECT_THROW(server::serve(other), std::runtime_error);
}

TEST_F(Serving, EndsWhileConnectionsAreOpen) {
  httplib::Client client("127.0.0.1", port_);
  client.set_keep_alive(true);
  ASSERT_TRUE(client.Get("/api/about"));
  const auto begin = std::chrono::steady_clock::now();
  stop();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(15));
  EXPECT_FALSE(client.Get("/api/about"));
}

}  // namespace
}  // namespace talus
