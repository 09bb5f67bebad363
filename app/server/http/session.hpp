#pragma once
// Who may speak with the server: whoever came by an address with a token, which works once, and has the cookie since.

#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace talus::server {

/// Hexadecimal digits of so many random bytes of the operating system.
[[nodiscard]] std::string random_hex(std::size_t bytes);

/// Compares in a time that does not tell where two texts differ.
[[nodiscard]] bool same_secret(std::string_view a, std::string_view b);

class Session {
 public:
  /// With a key of its own: a browser sends its cookies to whatever listens on the machine, on any port, and what one
  /// server's cookie opens is to be that server alone, until it ends. A key in a header of the page's own would not go
  /// to other ports; but links to files, pictures, reports and the stream of events can carry a cookie only. What is
  /// left: another user of the machine, to whose port the browser is led while this server runs (SameSite keeps pages
  /// of other sites from fetching it unseen).
  explicit Session(int port);

  /// A new token, which works once.
  [[nodiscard]] std::string new_token();
  /// Whether the token was one; it is none afterwards.
  [[nodiscard]] bool use_token(std::string_view token);

  /// What a browser is given for its token, for the header Set-Cookie: until the browser ends. (Lax, since the page
  /// that leads here may be a file.)
  [[nodiscard]] std::string cookie() const;
  /// Whether a header Cookie has it.
  [[nodiscard]] bool knows(std::string_view cookie_header) const;

 private:
  std::string name_, key_;
  std::mutex mutex_;
  std::set<std::string> tokens_;
};

}  // namespace talus::server
