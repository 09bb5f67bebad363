#pragma once
// Who may speak with the server: whoever came by an address with a token, which works once, and has the cookie since.

#include <filesystem>
#include <mutex>
#include <optional>
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
  /// The key of the user's sessions is kept in a file that only the user can read, so that a page goes on when the
  /// server is started again. Throws BadInput where it cannot be kept.
  explicit Session(const std::filesystem::path& key_file, int port);

  /// A new token, which works once.
  [[nodiscard]] std::string new_token();
  /// Whether the token was one; it is none afterwards.
  [[nodiscard]] bool use_token(std::string_view token);

  /// What a browser is given for its token, for the header Set-Cookie.
  [[nodiscard]] std::string cookie() const;
  /// Whether a header Cookie has it.
  [[nodiscard]] bool knows(std::string_view cookie_header) const;

 private:
  std::string name_, key_;
  std::mutex mutex_;
  std::set<std::string> tokens_;
};

/// Where the key is kept: in $XDG_STATE_HOME/talus, or ~/.local/state/talus.
[[nodiscard]] std::filesystem::path usual_key_file();

}  // namespace talus::server
