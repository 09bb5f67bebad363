#pragma once
// A server in this process on a temporary folder, and a client with its cookie.

#include "http/router.hpp"  // before any header of Eigen

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "serve.hpp"
#include "support/loopback.hpp"

namespace talus::testing_tools {

using server::Json;

/// An answer of the server.
struct Reply {
  int status = 0;
  std::string body;
  httplib::Headers headers;

  [[nodiscard]] Json json() const { return Json::parse(body, nullptr, false); }
  /// The text of the answer's single problem.
  [[nodiscard]] std::string problem() const {
    const Json all = json();
    if (!all.is_object() || !all.contains("problems") || all["problems"].size() != 1)
      return "not a single problem: " + body;
    return all["problems"][0]["text"].get<std::string>();
  }
};

/// The arrays of an answer, by name.
class ArraysOf {
 public:
  explicit ArraysOf(const Reply& reply) : bytes_(reply.body) {
    EXPECT_EQ(bytes_.substr(0, 4), "TALA");
    std::uint32_t length = 0;
    std::memcpy(&length, bytes_.data() + 4, sizeof length);
    EXPECT_EQ((8 + length) % 8, 0U);
    header = Json::parse(bytes_.substr(8, length));
    std::size_t at = 8 + length;
    for (const Json& array : header["arrays"]) {
      begins_[array["name"].get<std::string>()] = at;
      const std::string type = array["type"];
      const std::size_t width = type == "f64" ? 8 : type == "u8" ? 1 : type == "u16" ? 2 : 4;
      at = (at + array["count"].get<std::size_t>() * width + 7) / 8 * 8;
    }
    EXPECT_EQ(at, bytes_.size());
  }

  /// Expects the array to have this type.
  template <class T>
  [[nodiscard]] std::vector<T> get(const std::string& name, const std::string& type) const {
    for (const Json& array : header["arrays"]) {
      if (array["name"] != name) continue;
      EXPECT_EQ(array["type"], type);
      std::vector<T> values(array["count"].get<std::size_t>());
      if (!values.empty()) std::memcpy(values.data(), bytes_.data() + begins_.at(name), values.size() * sizeof(T));
      return values;
    }
    ADD_FAILURE() << "there is no array " << name;
    return {};
  }

  Json header;

 private:
  std::string bytes_;
  std::map<std::string, std::size_t> begins_;
};

/// A connection for sending arbitrary bytes.
class RawConnection {
 public:
  explicit RawConnection(int port) : socket_(connect_to_loopback(port)) { EXPECT_GE(socket_, 0); }
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;
  ~RawConnection() { ::close(socket_); }

  /// Sends as many bytes as the server reads: it need not read all of a request that it refuses.
  void send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
  }
  /// Reads the next answer and returns its status; 0 if there is none.
  [[nodiscard]] int status() {
    while (read_.find("\r\n\r\n") == std::string::npos)
      if (!read_more()) return 0;
    const std::size_t head = read_.find("\r\n\r\n") + 4, length = read_.find("Content-Length: ");
    const std::size_t size = head + (length < head ? std::stoul(read_.substr(length + 16)) : 0);
    while (read_.size() < size && read_more()) {
    }
    const int status = std::stoi(read_.substr(read_.find(' ')));
    read_.erase(0, size);
    return status;
  }
  /// Whether the server has not closed the connection yet.
  [[nodiscard]] bool is_open() const {
    char byte = 0;
    const ssize_t got = ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return got > 0 ? true : got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  }
  /// Waits for more bytes; true if the server closes the connection instead.
  [[nodiscard]] bool is_closed() { return read_.empty() && !read_more(); }

 private:
  bool read_more() {
    char bytes[4096];
    const ssize_t got = ::recv(socket_, bytes, sizeof bytes, 0);
    if (got > 0) read_.append(bytes, static_cast<std::size_t>(got));
    return got > 0;
  }

  int socket_;
  std::string read_;
};

class Served : public ::testing::Test {
 protected:
  explicit Served(server::Limits limits = {}) {
    std::signal(SIGPIPE, SIG_IGN);  // a client may disconnect during the response
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    base_ = std::filesystem::path(::testing::TempDir()) /
            ("talus_served_" + std::string(test->name()) + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(base_);
    std::filesystem::create_directories(path(""));
    options_.folder = path("");
    options_.port = 0;
    options_.limits = limits;
    start();
  }
  ~Served() override {
    stop();
    std::error_code ignored;
    std::filesystem::remove_all(base_, ignored);
  }

  void start() {
    stop_ = false;
    options_.stop = &stop_;
    std::promise<std::string> ready;
    options_.ready = [&](const std::string& address) { ready.set_value(address); };
    thread_ = std::thread([this] { server::serve(options_); });
    address_ = ready.get_future().get();
    const std::size_t colon = address_.rfind(':'), slash = address_.find("/?");
    port_ = std::stoi(address_.substr(colon + 1, slash - colon - 1));
    httplib::Client first("127.0.0.1", port_);
    const auto answer = first.Get(address_.substr(slash));
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->status, 303) << answer->body;
    cookie_ = answer->get_header_value("Set-Cookie");
    cookie_ = cookie_.substr(0, cookie_.find(';'));
  }
  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return base_ / "folder" / name; }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

  /// Sends a request, with the cookie unless `headers` has one.
  Reply send(const std::string& method, const std::string& what, const std::string& body = {},
             httplib::Headers headers = {}) const {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(600, 0);  // a build with sanitizers is slow
    if (headers.find("Cookie") == headers.end()) headers.emplace("Cookie", cookie_);
    httplib::Request request;
    request.method = method;
    request.path = what;
    request.headers = std::move(headers);
    request.body = body;
    const auto answer = client.send(request);
    if (!answer) {
      ADD_FAILURE() << method << ' ' << what << " was not answered: " << httplib::to_string(answer.error());
      return {};
    }
    return {answer->status, answer->body, answer->headers};
  }
  Reply get(const std::string& what) const { return send("GET", what); }
  Reply post(const std::string& what, const Json& body) const { return with_json("POST", what, body); }
  Reply put(const std::string& what, const Json& body) const { return with_json("PUT", what, body); }
  Reply with_json(const std::string& method, const std::string& what, const Json& body) const {
    return send(method, what, body.dump(), {{"Content-Type", "application/json"}});
  }
  Reply upload(const std::string& what, const std::string& bytes) const {
    return send("PUT", "/api/files/" + what, bytes, {{"Content-Type", "application/octet-stream"}});
  }

  std::filesystem::path base_;
  server::ServeOptions options_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
  std::string address_, cookie_;
  int port_ = 0;
};

}  // namespace talus::testing_tools
