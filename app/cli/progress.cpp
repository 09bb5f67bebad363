#include "progress.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "standard_streams.hpp"

namespace talus::cli {

namespace {

using namespace std::chrono_literals;

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds + 0.5);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::size_t columns_of_terminal() {
  winsize size{};
  constexpr std::size_t usual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

/// The text after a progress bar, if the bar fits. The line stays one column short of the terminal's width: some
/// terminals wrap a line that fills the last column.
std::string line_with_bar(const std::string& text, int percent, std::size_t columns) {
  constexpr std::size_t least = 8, most = 24, around = 3;  // "[", "] "
  const std::size_t room = columns - 1;
  if (room < text.size() + around + least) return text.substr(0, room);
  const std::size_t width = std::min(most, room - text.size() - around);
  const std::size_t full = static_cast<std::size_t>(percent) * width / 100;
  return fmt::format("[{:#<{}}{:.<{}}] {}", "", full, "", width - full, text);
}

}  // namespace

Progress::Progress(std::uint64_t total, std::string_view kind)
    : total_(total), kind_(kind), on_terminal_(isatty(STDERR_FILENO) == 1), begin_(Clock::now()), last_(begin_) {}

Progress::~Progress() {
  if (on_terminal_ && printed_) to_stderr("\r\x1b[K");
}

void Progress::operator()(std::uint64_t done) {
  const auto now = Clock::now();
  total_ = std::max(total_, done);
  if (!done_before_) {
    done_before_ = done;
    begin_ = last_ = now;
    return;
  }
  if (!is_due(now)) return;
  last_ = now;
  print(done, now);
}

bool Progress::is_due(Clock::time_point now) const {
  return now - last_ >= (on_terminal_ ? Clock::duration(100ms) : Clock::duration(10s));
}

void Progress::say(std::string_view what) {
  const auto now = Clock::now();
  if (!on_terminal_ && !is_due(now)) return;
  last_ = now;
  if (on_terminal_) {
    to_stderr("\r\x1b[K{}", what.substr(0, columns_of_terminal() - 1));
  } else {
    to_stderr("{}\n", what);
  }
  printed_ = true;
}

void Progress::print(std::uint64_t done, Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double rate = static_cast<double>(done - *done_before_) / seconds;
  const double left = static_cast<double>(total_ - done) / rate;
  const int percent = static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(total_));
  const std::string text = fmt::format("{} of {} {} ({} %), {:.{}f} {}/s, {} left", done, total_, kind_, percent, rate,
                                       rate < 10 ? 1 : 0, kind_, clock_text(left));
  if (on_terminal_) {
    to_stderr("\r\x1b[K{}", line_with_bar(text, percent, columns_of_terminal()));
  } else {
    to_stderr("{}\n", text);
  }
  printed_ = true;
}

}  // namespace talus::cli
