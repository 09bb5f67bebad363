#include "stop_signals.hpp"

#include <csignal>
#include <ctime>

#include "standard_streams.hpp"

namespace talus::cli {

namespace {

std::atomic<bool> is_stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

// Signals within two seconds of the first count as the first: some callers signal a program and its group.
volatile std::sig_atomic_t stop_asked_at = 0;
extern "C" void ask_to_stop(int signal) {
  const auto now = static_cast<std::sig_atomic_t>(std::time(nullptr));
  if (is_stop_wanted.exchange(true) && now - stop_asked_at >= 2) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  } else if (stop_asked_at == 0) {
    stop_asked_at = now;
  }
}

}  // namespace

const std::atomic<bool>& stop_wanted() { return is_stop_wanted; }

void catch_stop_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, ask_to_stop);
  catch_hangup(ask_to_stop);
}

}  // namespace talus::cli
