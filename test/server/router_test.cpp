// Access checks, and malformed requests.

#include "server/served.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Served;

class Requests : public Served {
 protected:
  Requests() : Served({.upload_bytes = 4096, .json_bytes = 1024}) {}
};

TEST_F(Requests, WithTheCookieAreAnswered) {
  const Reply about = get("/api/about");
  EXPECT_EQ(about.status, 200);
  EXPECT_EQ(about.json()["limits"]["upload_bytes"], 4096);
}

TEST_F(Requests, WithoutTheCookieAreRefused) {
  for (const std::string cookie : {"", "talus-1=0", "talus=1; other=2"}) {
    const Reply reply = send("GET", "/api/about", "", {{"Cookie", cookie}});
    EXPECT_EQ(reply.status, 403) << cookie;
    EXPECT_EQ(reply.problem(), "this browser has no session. Open the address that `talus serve` printed");
  }
  std::string guess = cookie_;
  guess.back() = guess.back() == '0' ? '1' : '0';
  EXPECT_EQ(send("GET", "/api/about", "", {{"Cookie", guess}}).status, 403);
}

TEST_F(Requests, WithAnotherHostAreRefused) {
  for (const std::string& host : {std::string("evil.example"), "evil.example:" + std::to_string(port_),
                                  std::string("127.0.0.1:1"), std::string("127.0.0.1")}) {
    const Reply reply = send("GET", "/api/about", "", {{"Host", host}});
    EXPECT_EQ(reply.status, 403) << host;
    EXPECT_EQ(reply.problem(), "Host: this is not the server's name. Use the address that it printed");
  }
  EXPECT_EQ(send("GET", "/api/about", "", {{"Host", "localhost:" + std::to_string(port_)}}).status, 200);
}

TEST_F(Requests, WithAnotherOriginAreRefused) {
  for (const std::string& origin : {std::string("http://evil.example"), std::string("null"),
                                    "https://127.0.0.1:" + std::to_string(port_), std::string("http://127.0.0.1:1")}) {
    const Reply reply = send("GET", "/api/about", "", {{"Origin", origin}});
    EXPECT_EQ(reply.status, 403) << origin;
    EXPECT_EQ(reply.problem(), "Origin: requests from other sites are not allowed");
  }
  EXPECT_EQ(send("GET", "/api/about", "", {{"Origin", "http://127.0.0.1:" + std::to_string(port_)}}).status, 200);
}

TEST_F(Requests, WithAnotherTypeOfBodyAreRefused) {
  for (const std::string type : {"text/plain", "application/x-www-form-urlencoded", "application/jsonp", ""}) {
    EXPECT_EQ(send("POST", "/api/tokens", "{}", {{"Content-Type", type}}).status, 415) << type;
    EXPECT_EQ(send("PUT", "/api/files/a.csv", "1", {{"Content-Type", type}}).status, 415) << type;
  }
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
}

TEST_F(Requests, WithInvalidJsonAreRefused) {
  const auto posted = [&](const std::string& body) {
    return send("POST", "/api/model", body, {{"Content-Type", "application/json; charset=utf-8"}});
  };
  for (const std::string body : {"", "{", "{\"file\": }", "{\"mean\": 1e999}", "\xff\xfe", "nul"}) {
    EXPECT_EQ(posted(body).status, 400) << body;
    EXPECT_EQ(posted(body).problem(), "the request's body is not JSON") << body;
  }
  for (const std::string body : {"[]", "1", "\"text\"", "null"})
    EXPECT_EQ(posted(body).problem(), "the request's body is not a JSON object") << body;
  const Reply deep = posted("{\"text\": " + std::string(300, '[') + std::string(300, ']') + "}");
  EXPECT_EQ(deep.status, 400);
  EXPECT_EQ(deep.problem(), "lists in the request are nested too deeply");
}

TEST_F(Requests, WithTooLargeABodyAreRefused) {
  const Json body{{"file", "a.toml"}, {"text", std::string(2000, '#')}};
  const Reply reply = post("/api/model", body);
  EXPECT_EQ(reply.status, 413);
  EXPECT_EQ(reply.problem(), "the request is too large (at most 1024 bytes are accepted)");
}

TEST_F(Requests, WithMissingUnknownOrMistypedKeysAreRefused) {
  EXPECT_EQ(post("/api/model", {{"file", "a.toml"}}).problem(), "text: is missing");
  EXPECT_EQ(post("/api/model", {{"file", "a.toml"}, {"text", 1}}).problem(), "text: is not a text");
  EXPECT_EQ(post("/api/model", {{"file", "a.toml"}, {"text", ""}, {"txt", ""}}).problem(),
            "txt: is not a key of this request");
  EXPECT_EQ(post("/api/distribution", {{"mean", "1"}}).problem(), "mean: is not a number");
  EXPECT_EQ(post("/api/distribution", {{"men", 1}}).status, 400);
}

TEST_F(Requests, DoNotBeginInTheRestOfARefusedBody) {
  write("a.csv", "1");
  const auto put = [&](const std::string& headers, std::size_t length) {
    return "PUT /api/files/a.csv HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n" + headers +
           "Content-Length: " + std::to_string(length) + "\r\n\r\n" + std::string(length, 'x');
  };
  const std::string cookie = "Cookie: " + cookie_ + "\r\n", type = "Content-Type: application/octet-stream\r\n";
  const std::string about =
      "GET /api/about HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n" + cookie + "\r\n";
  {
    // A short body is read to its end, and the connection stays open.
    testing_tools::RawConnection connection(port_);
    connection.send(put(cookie + type, 1000));
    EXPECT_EQ(connection.status(), 409);
    connection.send(put(cookie + "Content-Type: text/plain\r\n", 1000));
    EXPECT_EQ(connection.status(), 415);
    connection.send(about);
    EXPECT_EQ(connection.status(), 200);
  }
  const std::string parts = "Content-Type: multipart/form-data; boundary=x\r\n";
  const std::string refused_unread[] = {put(type, 1000), put(cookie + type, 2u << 20u), put(cookie + parts, 1000)};
  for (const std::string& request : refused_unread) {
    testing_tools::RawConnection connection(port_);
    connection.send(request);
    const int status = connection.status();
    EXPECT_TRUE(status == 403 || status == 409 || status == 415) << status;
    EXPECT_TRUE(connection.is_closed());
  }
}

TEST_F(Requests, ForUnknownPathsAreAnsweredInJson) {
  for (const std::string what : {"/api/nothing", "/api/models/0123/nothing", "/api"}) {
    const Reply reply = get(what);
    EXPECT_EQ(reply.status, 404) << what;
    EXPECT_EQ(reply.problem(), what + ": not found");
  }
}

TEST_F(Requests, AreAllAnsweredWithTheContentPolicy) {
  for (const std::string what : {"/", "/api/about", "/api/nothing"}) {
    const Reply reply = get(what);
    const auto header = [&](const char* name) {
      const auto found = reply.headers.find(name);
      return found == reply.headers.end() ? "" : found->second;
    };
    EXPECT_NE(header("Content-Security-Policy").find("default-src 'none'"), std::string::npos) << what;
    EXPECT_EQ(header("X-Content-Type-Options"), "nosniff") << what;
    EXPECT_EQ(reply.headers.count("Access-Control-Allow-Origin"), 0U) << what;
  }
}

}  // namespace
}  // namespace talus
