// Tokens work once; the cookie is valid until the server ends.

#include "server/served.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Served;

class SessionOf : public Served {
 protected:
  [[nodiscard]] std::string token_path() const { return address_.substr(address_.find("/?")); }
};

TEST_F(SessionOf, AcceptsATokenOnce) {
  const Reply again = send("GET", token_path(), "", {{"Cookie", "none=1"}});  // the fixture has used it
  EXPECT_EQ(again.status, 403);
  EXPECT_NE(again.body.find("This address has been used"), std::string::npos);
  EXPECT_EQ(again.headers.count("Set-Cookie"), 0U);
  EXPECT_EQ(send("GET", "/?token=0123456789abcdef", "", {{"Cookie", "none=1"}}).status, 403);
  EXPECT_EQ(send("GET", "/?token=", "", {{"Cookie", "none=1"}}).status, 403);
}

TEST_F(SessionOf, ProvidesAnotherAddress) {
  const std::string address = post("/api/tokens", Json::object()).json()["address"];
  const std::string what = address.substr(address.find("/?"));
  const Reply first = send("GET", what, "", {{"Cookie", "none=1"}});
  EXPECT_EQ(first.status, 303);
  EXPECT_EQ(first.headers.find("Set-Cookie")->second.substr(0, cookie_.size()), cookie_);
  EXPECT_NE(first.headers.find("Set-Cookie")->second.find("HttpOnly; SameSite=Lax"), std::string::npos);
  EXPECT_EQ(send("GET", what, "", {{"Cookie", "none=1"}}).status, 403);
}

TEST_F(SessionOf, EndsWithItsServer) {
  const std::string cookie = cookie_;
  stop();
  options_.port = port_;
  start();
  EXPECT_EQ(cookie_.substr(0, cookie_.find('=')), cookie.substr(0, cookie.find('=')));  // named by the port
  EXPECT_EQ(send("GET", "/api/about", "", {{"Cookie", cookie}}).status, 403);
  EXPECT_EQ(get("/api/about").status, 200);
}

// A browser sends the cookie to all ports of the machine: another server's cookie must not open this one.
TEST_F(SessionOf, IsLimitedToOneServer) {
  server::Session first(8425), second(8425), elsewhere(8426);
  const auto pair = [](const server::Session& session) {
    return session.cookie().substr(0, session.cookie().find(';'));
  };
  EXPECT_TRUE(first.accepts("other=1; " + pair(first)));
  EXPECT_FALSE(second.accepts(pair(first)));
  EXPECT_FALSE(elsewhere.accepts(pair(first)));
  const std::string key = pair(first).substr(pair(first).find('=') + 1);
  EXPECT_FALSE(elsewhere.accepts("talus-8426=" + key));
  EXPECT_EQ(first.cookie().find("Max-Age"), std::string::npos);  // until the browser is closed
}

TEST(Secrets, AreComparedCompletely) {
  EXPECT_TRUE(server::same_secret("abc", "abc"));
  EXPECT_FALSE(server::same_secret("abc", "abd"));
  EXPECT_FALSE(server::same_secret("abc", "ab"));
  EXPECT_FALSE(server::same_secret("", "a"));
  EXPECT_EQ(server::random_hex(16).size(), 32U);
  EXPECT_NE(server::random_hex(16), server::random_hex(16));
}

}  // namespace
}  // namespace talus
