#pragma once
// Access to the server: the printed address has a token, which works once; the browser gets a cookie in exchange.

#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace talus::server {

/// Random bytes of the operating system, as hexadecimal digits.
[[nodiscard]] std::string random_hex(std::size_t bytes);

/// Compares two texts; the time does not depend on where they differ.
[[nodiscard]] bool same_secret(std::string_view a, std::string_view b);

class Session {
 public:
  /// Creates a random key, valid only for this server and its lifetime. Browsers send cookies of 127.0.0.1 to every
  /// port of the machine. A key in a header would avoid that, but links to files, pictures, reports and the event
  /// stream can only carry cookies. The remaining risk is another user of the machine, if the browser is directed to
  /// that user's port while this server runs (SameSite prevents hidden requests by pages of other sites).
  explicit Session(int port);

  /// Creates a token, which works once.
  [[nodiscard]] std::string new_token();
  /// Whether the token was valid. It no longer is afterwards.
  [[nodiscard]] bool use_token(std::string_view token);

  /// The header Set-Cookie in exchange for a token: a cookie until the browser is closed. (SameSite is Lax, not Strict,
  /// because the page that redirects to the server may be a file.)
  [[nodiscard]] std::string cookie() const;
  /// Whether a header Cookie contains this session's cookie.
  [[nodiscard]] bool accepts(std::string_view cookie_header) const;

 private:
  std::string name_, key_;
  std::mutex mutex_;
  std::set<std::string> tokens_;
};

}  // namespace talus::server
