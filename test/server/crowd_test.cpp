// Many idle connections, or slow readers, do not delay other requests.

#include "server/served.hpp"

#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace talus {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

using testing_tools::Served;

/// Connections that are closed with the object.
class Connections {
 public:
  ~Connections() {
    for (const int each : open_) close(each);
  }
  /// Returns the socket, -1 on failure.
  int add(int port, int receive_buffer = 0) {
    const int made = testing_tools::connect_to_loopback(port, receive_buffer);
    if (made >= 0) open_.push_back(made);
    return made;
  }

 private:
  std::vector<int> open_;
};

class Crowd : public Served {
 protected:
  void SetUp() override {
    // Both ends of each connection are in this process.
    rlimit files{};
    getrlimit(RLIMIT_NOFILE, &files);
    before_ = files;
    files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
    if (files.rlim_cur < 2200 || setrlimit(RLIMIT_NOFILE, &files) != 0)
      GTEST_SKIP() << "the limit of open files is too low";
  }
  void TearDown() override { setrlimit(RLIMIT_NOFILE, &before_); }

  rlimit before_{};
};

TEST_F(Crowd, OfAThousandConnectionsDelaysNobody) {
  Connections idle;
  const std::string half = "GET /api/about HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  for (int k = 0; k < 1000; ++k) {
    const int made = idle.add(port_);
    ASSERT_GE(made, 0) << k;
    if (k % 2 == 0) {
      ASSERT_EQ(::send(made, half.data(), half.size(), MSG_NOSIGNAL), static_cast<ssize_t>(half.size()));
    }
  }
  const auto begin = Clock::now();
  EXPECT_EQ(get("/api/about").status, 200);
  EXPECT_LT(Clock::now() - begin, 15s);
}

TEST_F(Crowd, OfSlowReadersDelaysNobody) {
  // A large answer that is not read.
  const std::string text =
      "[terrain]\nsection = [[0, 10], [10, 0]]\n[[material]]\nname = \"A\"\n[[seeder]]\nposition = [1, 9]\nmass_kg = "
      "1\n#" +
      std::string(8 << 20, '#') + "\n";
  write("large.toml", text);
  Connections slow;
  for (int k = 0; k < 20; ++k) {
    const int made = slow.add(port_, 4096);
    ASSERT_GE(made, 0);
    const std::string request =
        "GET /api/project?file=large.toml HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) +
        "\r\nCookie: " + cookie_ + "\r\n\r\n";
    ASSERT_EQ(::send(made, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
  }
  std::this_thread::sleep_for(200ms);
  const auto begin = Clock::now();
  EXPECT_EQ(get("/api/about").status, 200);
  EXPECT_LT(Clock::now() - begin, 15s);
}

// Each connection sends a byte now and then, so that none is idle for long.
TEST_F(Crowd, OfTricklingConnectionsDelaysNobody) {
  Connections trickling;
  std::vector<int> open;
  std::atomic<bool> has_ended{false};
  std::thread sending;
  for (int k = 0; k < 1500; ++k) {
    const int made = trickling.add(port_);
    ASSERT_GE(made, 0) << k;
    open.push_back(made);
  }
  sending = std::thread([&] {
    for (std::size_t at = 0; !has_ended; ++at) {
      for (const int each : open) (void)!::send(each, &"GET / HTTP/1.1\r\n"[at % 16], 1, MSG_NOSIGNAL | MSG_DONTWAIT);
      std::this_thread::sleep_for(100ms);
    }
  });
  for (int k = 0; k < 20; ++k) {
    const auto begin = Clock::now();
    EXPECT_EQ(get("/api/about").status, 200);
    EXPECT_LT(Clock::now() - begin, 15s);
    std::this_thread::sleep_for(50ms);
  }
  has_ended = true;
  sending.join();
}

}  // namespace
}  // namespace talus
