#include "http/session.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <vector>

namespace talus::server {

std::string random_hex(std::size_t bytes) {
  std::vector<unsigned char> random(bytes);
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t got = getrandom(random.data() + done, bytes - done, 0);
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  std::string text;
  for (const unsigned char byte : random) text += fmt::format("{:02x}", byte);
  return text;
}

bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

Session::Session(int port) : name_(fmt::format("talus-{}", port)), key_(random_hex(32)) {}

std::string Session::new_token() {
  std::string token = random_hex(16);
  const std::lock_guard lock(mutex_);
  tokens_.insert(token);
  return token;
}

bool Session::use_token(std::string_view token) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(tokens_.begin(), tokens_.end(), [&](const std::string& known) { return same_secret(known, token); });
  if (found == tokens_.end()) return false;
  tokens_.erase(found);
  return true;
}

std::string Session::cookie() const { return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Lax", name_, key_); }

bool Session::accepts(std::string_view cookie_header) const {
  const std::string start = name_ + "=";
  while (!cookie_header.empty()) {
    const std::size_t end = std::min(cookie_header.find(';'), cookie_header.size());
    std::string_view part = cookie_header.substr(0, end);
    while (part.starts_with(' ')) part.remove_prefix(1);
    if (part.starts_with(start) && same_secret(part.substr(start.size()), key_)) return true;
    cookie_header.remove_prefix(std::min(end + 1, cookie_header.size()));
  }
  return false;
}

}  // namespace talus::server
