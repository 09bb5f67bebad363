#include "http/session.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "talus/core/problems.hpp"

namespace talus::server {

namespace {

constexpr std::size_t key_digits = 64;

bool is_key(std::string_view text) {
  return text.size() == key_digits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

[[noreturn]] void cannot_keep(const std::filesystem::path& file, const char* what) {
  throw BadInput(Problem{.file = file.string(),
                         .what = fmt::format("the key of the sessions {}", what),
                         .why = std::strerror(errno),
                         .hint = "Name another folder for it by XDG_STATE_HOME"});
}

/// Nothing where there is none that can be trusted: another user could have put it there, or could read it.
std::string read_key(const std::filesystem::path& file) {
  const int opened = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (opened < 0) return {};
  struct stat state {};
  std::string key(key_digits, '\0');
  const bool is_own = fstat(opened, &state) == 0 && S_ISREG(state.st_mode) && state.st_uid == geteuid() &&
                      (state.st_mode & 077) == 0 && state.st_size == static_cast<off_t>(key_digits);
  const bool is_read = is_own && read(opened, key.data(), key.size()) == static_cast<ssize_t>(key.size());
  close(opened);
  return is_read && is_key(key) ? key : std::string();
}

void write_key(const std::filesystem::path& file, const std::string& key) {
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  unlink(file.c_str());
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (opened < 0) cannot_keep(file, "cannot be kept");
  const bool is_written = write(opened, key.data(), key.size()) == static_cast<ssize_t>(key.size());
  if (close(opened) != 0 || !is_written) cannot_keep(file, "cannot be written");
}

}  // namespace

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

Session::Session(const std::filesystem::path& key_file, int port)
    : name_(fmt::format("talus-{}", port)), key_(read_key(key_file)) {
  if (!key_.empty()) return;
  key_ = random_hex(key_digits / 2);
  write_key(key_file, key_);
}

std::string Session::new_token() {
  std::string token = random_hex(16);
  const std::lock_guard lock(mutex_);
  tokens_.insert(token);
  return token;
}

bool Session::use_token(std::string_view token) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(tokens_.begin(), tokens_.end(),
                                  [&](const std::string& known) { return same_secret(known, token); });
  if (found == tokens_.end()) return false;
  tokens_.erase(found);
  return true;
}

std::string Session::cookie() const {
  return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age=2592000", name_, key_);
}

bool Session::knows(std::string_view cookie_header) const {
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

std::filesystem::path usual_key_file() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/')
    return std::filesystem::path(state) / "talus" / "sessions.key";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / ".local" / "state" / "talus" / "sessions.key";
}

}  // namespace talus::server
