#include "progress.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace talus::cli {

namespace {

using namespace std::chrono_literals;

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds + 0.5);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(std::uint64_t total)
    : total_(total), on_terminal_(isatty(STDERR_FILENO) == 1), begin_(Clock::now()), last_(begin_) {}

Progress::~Progress() {
  if (on_terminal_ && printed_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::operator()(std::uint64_t done) {
  const auto now = Clock::now();
  if (!done_before_) {
    done_before_ = done;
    begin_ = last_ = now;
    return;
  }
  if (now - last_ < (on_terminal_ ? Clock::duration(100ms) : Clock::duration(10s))) return;
  last_ = now;
  print(done, now);
}

void Progress::print(std::uint64_t done, Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double rate = static_cast<double>(done - *done_before_) / seconds;
  const double left = static_cast<double>(total_ - done) / rate;
  const int percent = static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(total_));
  const std::string text =
      fmt::format("{} of {} rocks ({} %), {:.0f} rocks/s, {} left", done, total_, percent, rate, clock_text(left));
  if (on_terminal_) {
    constexpr int width = 24;
    const int full = percent * width / 100;
    fmt::print(stderr, "\r\x1b[K[{:#<{}}{:.<{}}] {}", "", full, "", width - full, text);
    std::fflush(stderr);
  } else {
    fmt::print(stderr, "{}\n", text);
  }
  printed_ = true;
}

}  // namespace talus::cli
