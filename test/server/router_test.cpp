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

TEST_F(Requests, WithTwoHostsOrLengthsAreRefusedAtOnce) {
  const std::string host = "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n", cookie = "Cookie: " + cookie_ + "\r\n";
  const std::string type = "Content-Type: application/json\r\n";
  for (const std::string& head :
       {"GET /api/about HTTP/1.1\r\n" + host + host + cookie,
        "GET /api/about HTTP/1.1\r\n" + host + "Host: x\r\n" + cookie,
        "POST /api/tokens HTTP/1.1\r\n" + host + cookie + type + "Content-Length: 2\r\nContent-Length: 1000\r\n",
        "POST /api/tokens HTTP/1.1\r\n" + host + cookie + type + "Content-Length: -1\r\n",
        "POST /api/tokens HTTP/1.1\r\n" + host + cookie + type + "Content-Length: 2, 2\r\n"}) {
    testing_tools::RawConnection connection(port_);
    connection.send(head + "\r\n");
    EXPECT_EQ(connection.status(), 400) << head;
    EXPECT_TRUE(connection.is_closed()) << head;
  }
}

TEST_F(Requests, ForAPartGetItIfItBeginsBeforeTheEnd) {
  const auto part = [&](const std::string& range) {
    return send("GET", "/api/about", "", {{"Range", "bytes=" + range}});
  };
  const auto content_range = [](const Reply& reply) {
    const auto found = reply.headers.find("Content-Range");
    return found == reply.headers.end() ? std::string() : found->second;
  };
  const std::string whole = get("/api/about").body, size = std::to_string(whole.size());
  const std::size_t bytes = whole.size();
  ASSERT_GT(bytes, 100U);
  const auto expect = [&](const std::string& range, std::size_t first, std::size_t end) {
    const Reply reply = part(range);
    EXPECT_EQ(reply.status, 206) << range;
    EXPECT_EQ(reply.body, whole.substr(first, end - first)) << range;
    EXPECT_EQ(content_range(reply), "bytes " + std::to_string(first) + '-' + std::to_string(end - 1) + '/' + size);
  };
  expect("0-3", 0, 4);
  expect("5-", 5, bytes);
  expect("-7", bytes - 7, bytes);
  expect("-1000000", 0, bytes);
  expect("3-1000000000000", 3, bytes);
  for (const std::string& range : {size + '-', size + "-1000000", std::string("1000000000000-"), std::string("-0")}) {
    const Reply reply = part(range);
    EXPECT_EQ(reply.status, 416) << range;
    EXPECT_EQ(content_range(reply), "bytes */" + size) << range;
    EXPECT_EQ(reply.problem(), "Range: begins beyond the end of the answer (it has " + size + " bytes)");
  }
}

TEST_F(Requests, ForAPartOfThePageGetNoMoreThanIsThere) {
  testing_tools::RawConnection connection(port_);
  const auto status = [&](const std::string& range) {
    connection.send("GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\nCookie: " + cookie_ +
                    "\r\nRange: bytes=" + range + "\r\n\r\n");
    return connection.status();
  };
  for (const std::string range : {"0-3", "5-", "-7", "3-1000000000000"}) EXPECT_EQ(status(range), 206) << range;
  for (const std::string range : {"1000000000000-", "-0"}) EXPECT_EQ(status(range), 416) << range;
  EXPECT_EQ(status("0-3"), 206) << "the connection goes on";
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
