// Endless or excessive requests cost the server almost nothing.

#include "server/served.hpp"

#include <sys/socket.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cli/child.hpp"
#include "cli/program.hpp"

namespace talus {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using testing_tools::RawConnection;
using testing_tools::Served;

class Greedy : public Served {
 protected:
  /// Memory of this process, which contains the server [bytes].
  static std::size_t resident_memory() {
    std::ifstream in("/proc/self/statm");
    std::size_t pages = 0;
    in >> pages >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  }
  /// Sends `begin` and then `piece` repeatedly, up to `bytes`. Returns the status of the answer, 0 if the server closes
  /// the connection without one. Expects the server's memory not to grow.
  int flood(const std::string& begin, const std::string& piece, std::size_t bytes) const {
    const std::size_t before = resident_memory();
    RawConnection connection(port_);
    connection.send(begin);
    std::string pieces;
    while (pieces.size() < (1u << 20u)) pieces += piece;
    for (std::size_t sent = 0; sent < bytes && connection.is_open(); sent += pieces.size()) connection.send(pieces);
    EXPECT_LT(resident_memory(), before + (32u << 20u));
    return connection.status();
  }
  [[nodiscard]] std::string host() const { return "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n"; }
  [[nodiscard]] std::string with_session() const { return host() + "Cookie: " + cookie_ + "\r\n"; }
};

constexpr std::size_t much = 256u << 20u;

TEST_F(Greedy, HeadersAreCutOff) {
  for (const std::string& session : {host(), with_session()}) {
    const int status = flood("GET / HTTP/1.1\r\n" + session, "X-More: 0123456789\r\n", much);
    EXPECT_TRUE(status == 431 || status == 0) << status;
  }
  // Up to the limit they are accepted.
  RawConnection connection(port_);
  connection.send("GET /api/about HTTP/1.1\r\n" + with_session());
  for (int k = 0; k < 200; ++k) connection.send("X-" + std::to_string(k) + ": " + std::string(100, 'x') + "\r\n");
  connection.send("\r\n");
  EXPECT_EQ(connection.status(), 200);
  connection.send("GET /api/about HTTP/1.1\r\n" + with_session());
  for (int k = 0; k < 400; ++k) connection.send("X-" + std::to_string(k) + ": " + std::string(100, 'x') + "\r\n");
  EXPECT_EQ(connection.status(), 431);
}

TEST_F(Greedy, ARequestLineIsCutOff) {
  const int status = flood("GET /", "aaaaaaaaaaaaaaaa", much);
  EXPECT_TRUE(status == 431 || status == 0) << status;
}

// The library does not recognise such lines as the end of a head.
TEST_F(Greedy, LinesWithoutCarriageReturnsAreCutOff) {
  const int status = flood("GET / HTTP/1.1\n" + host() + "\n\n", "X: 1\n", much);
  EXPECT_TRUE(status == 431 || status == 400 || status == 0) << status;
}

TEST_F(Greedy, UnexpectedBodiesAreNotRead) {
  const std::string length = "Content-Length: " + std::to_string(much) + "\r\n\r\n", piece(4096, 'x');
  for (const char* line : {"POST / HTTP/1.1\r\n", "POST /api/nothing HTTP/1.1\r\n", "PUT /nothing HTTP/1.1\r\n",
                           "PATCH /api/x HTTP/1.1\r\n", "DELETE /api/runs/x HTTP/1.1\r\n", "GET / HTTP/1.1\r\n"}) {
    const int without = flood(line + host() + length, piece, much),
              with = flood(line + with_session() + length, piece, much);
    EXPECT_TRUE(without == 403 || without == 400 || without == 0) << line << without;
    EXPECT_TRUE(with == 404 || with == 400 || with == 0) << line << with;
  }
  const int chunked = flood("POST /api/model HTTP/1.1\r\nTransfer-Encoding: chunked\r\n" + with_session() + "\r\n",
                            "1000000000000000", much);  // an endless length of a chunk
  EXPECT_TRUE(chunked == 411 || chunked == 0) << chunked;
}

TEST_F(Greedy, RequestsWithoutASessionAreRefused) {
  for (const char* what : {"/api/about", "/assets/index.js", "/favicon.svg", "/nothing"})
    EXPECT_EQ(send("GET", what, "", {{"Cookie", "none=1"}}).status, 403) << what;
  EXPECT_EQ(send("POST", "/", "{}", {{"Cookie", "none=1"}}).status, 403);
  EXPECT_EQ(send("OPTIONS", "/api/about").status, 405);
}

TEST_F(Greedy, ManyRangesAreRefused) {
  write("a.toml", std::string(100'000, '#'));
  std::string ranges = "bytes=0-";
  for (int k = 0; k < 2000; ++k) ranges += ",0-";
  RawConnection connection(port_);
  connection.send("GET / HTTP/1.1\r\n" + with_session() + "Range: " + ranges + "\r\n\r\n");
  EXPECT_EQ(connection.status(), 416);
  EXPECT_EQ(send("GET", "/", "", {{"Range", "bytes=0-3"}}).status, 206);
}

// Single bytes do not extend the time limit of a head.
class Slow : public Served {
 protected:
  static server::Limits limits() {
    server::Limits limits;
    limits.head_time = 300ms;
    return limits;
  }
  Slow() : Served(limits()) {}
};

TEST_F(Slow, HeadsAreCutOff) {
  RawConnection connection(port_);
  const std::string head =
      "GET /api/about HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\nCookie: " + cookie_;
  const auto begin = Clock::now();
  std::size_t sent = 0;
  while (connection.is_open() && Clock::now() - begin < 1min) {
    connection.send(head.substr(sent++ % head.size(), 1));
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_LT(Clock::now() - begin, 30s);
}

TEST_F(Slow, HeadsOfEmptyLinesAreCutOff) {
  RawConnection connection(port_);
  const auto begin = Clock::now();
  while (connection.is_open() && Clock::now() - begin < 1min) {
    connection.send("\r\n\r\n");
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_LT(Clock::now() - begin, 30s);
  EXPECT_EQ(connection.status(), 0);
}

TEST_F(Greedy, EmptyLinesBeforeARequestAreIgnored) {
  RawConnection connection(port_);
  for (int k = 0; k < 3; ++k) {
    connection.send("\r\n\r\nGET /api/about HTTP/1.1\r\n" + with_session() + "\r\n\r\n");
    EXPECT_EQ(connection.status(), 200);
  }
}

// The browser is opened with a page in a private folder: all users can read the arguments of a program.
TEST(OpenedWorkbench, HidesItsToken) {
  const test::Workplace work;
  const auto open = work / "xdg-open";
  work.write("xdg-open", "#!/bin/sh\nprintf '%s\\n' \"$@\" > " + (work / "called").string() + "\ncat \"$1\" > " +
                             (work / "page").string() + "\nstat -c %a \"$(dirname \"$1\")\" > " +
                             (work / "mode").string() + "\nmv " + (work / "page").string() + " " +
                             (work / "shown").string() + "\n");
  std::filesystem::permissions(open, std::filesystem::perms::owner_all);
  std::string path = "PATH=" + open.parent_path().string() + ":";
  path += std::getenv("PATH");
  test::Child child({"serve", open.parent_path().string(), "--port", "0", "--open"}, work / "said", {"env", path});
  ASSERT_TRUE(test::appears(work / "shown")) << work.read("said");
  const std::string said = work.read("said"), called = work.read("called"), page = work.read("shown");
  const std::size_t at = said.find("http://");
  const std::string address = said.substr(at, said.find('\n', at) - at);
  EXPECT_EQ(called.find("token"), std::string::npos) << called;
  EXPECT_NE(page.find(address), std::string::npos) << page;
  EXPECT_EQ(work.read("mode"), "700\n");
  child.signal(SIGINT);
  EXPECT_EQ(child.wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(called.substr(0, called.find('\n')))) << called;
}

}  // namespace
}  // namespace talus
