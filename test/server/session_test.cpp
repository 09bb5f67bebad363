// Tokens that work once, and a cookie that outlives the server.

#include "server/served.hpp"

#include <sys/stat.h>

namespace talus {
namespace {

namespace fs = std::filesystem;

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Served;

class SessionOf : public Served {
 protected:
  [[nodiscard]] std::string token_path() const { return address_.substr(address_.find("/?")); }
};

TEST_F(SessionOf, TakesATokenOnce) {
  const Reply again = send("GET", token_path(), "", {{"Cookie", "none=1"}});  // the fixture has used it
  EXPECT_EQ(again.status, 403);
  EXPECT_NE(again.body.find("This address has been used"), std::string::npos);
  EXPECT_EQ(again.headers.count("Set-Cookie"), 0U);
  EXPECT_EQ(send("GET", "/?token=0123456789abcdef", "", {{"Cookie", "none=1"}}).status, 403);
  EXPECT_EQ(send("GET", "/?token=", "", {{"Cookie", "none=1"}}).status, 403);
}

TEST_F(SessionOf, GivesAnotherAddressToWhoeverIsIn) {
  const std::string address = post("/api/tokens", Json::object()).json()["address"];
  const std::string what = address.substr(address.find("/?"));
  const Reply first = send("GET", what, "", {{"Cookie", "none=1"}});
  EXPECT_EQ(first.status, 303);
  EXPECT_EQ(first.headers.find("Set-Cookie")->second.substr(0, cookie_.size()), cookie_);
  EXPECT_NE(first.headers.find("Set-Cookie")->second.find("HttpOnly; SameSite=Strict"), std::string::npos);
  EXPECT_EQ(send("GET", what, "", {{"Cookie", "none=1"}}).status, 403);
}

TEST_F(SessionOf, OutlivesAServerThatIsStartedAgainOnItsPort) {
  const std::string cookie = cookie_;
  stop();
  options_.port = port_;
  start();
  EXPECT_EQ(send("GET", "/api/about", "", {{"Cookie", cookie}}).status, 200);
}

TEST_F(SessionOf, IsOfOnePort) {
  const std::string cookie = cookie_;
  const int before = port_;
  stop();
  options_.port = 0;
  start();
  if (port_ == before) GTEST_SKIP() << "the same port was free again";
  EXPECT_EQ(send("GET", "/api/about", "", {{"Cookie", cookie}}).status, 403);
}

TEST_F(SessionOf, KeepsItsKeyFromOthers) {
  struct stat state {};
  ASSERT_EQ(::stat(options_.key_file.c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 0777, 0600U);
  const std::string cookie = cookie_;
  stop();
  fs::permissions(options_.key_file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read);
  options_.port = port_;
  start();  // a key that others could read is none: there is a new one
  EXPECT_EQ(send("GET", "/api/about", "", {{"Cookie", cookie}}).status, 403);
  EXPECT_EQ(get("/api/about").status, 200);
  ASSERT_EQ(::stat(options_.key_file.c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 0777, 0600U);
}

TEST(Secrets, AreComparedWhole) {
  EXPECT_TRUE(server::same_secret("abc", "abc"));
  EXPECT_FALSE(server::same_secret("abc", "abd"));
  EXPECT_FALSE(server::same_secret("abc", "ab"));
  EXPECT_FALSE(server::same_secret("", "a"));
  EXPECT_EQ(server::random_hex(16).size(), 32U);
  EXPECT_NE(server::random_hex(16), server::random_hex(16));
}

}  // namespace
}  // namespace talus
