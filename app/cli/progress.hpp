#pragma once
// Progress of a campaign: one line that is updated in place on a terminal, occasional plain lines elsewhere.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace talus::cli {

class Progress {
 public:
  /// `kind`, for messages: "rocks".
  explicit Progress(std::uint64_t total, std::string_view kind = "rocks");
  ~Progress();
  void operator()(std::uint64_t done);
  /// There is more, or less, to do than was known.
  void set_total(std::uint64_t total) { total_ = total; }
  /// Says what is being done instead, where the remaining time is not known: at once on a terminal, elsewhere if the
  /// last line is old.
  void say(std::string_view what);

 private:
  using Clock = std::chrono::steady_clock;
  void print(std::uint64_t done, Clock::time_point now);
  [[nodiscard]] bool is_due(Clock::time_point now) const;

  std::uint64_t total_;
  std::string kind_;
  bool on_terminal_;
  bool printed_ = false;
  std::optional<std::uint64_t> done_before_;  // at the first call: these rocks do not count for the rate
  Clock::time_point begin_, last_;
};

}  // namespace talus::cli
