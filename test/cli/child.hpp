#pragma once
// The program as a child process that can be killed and whose memory is measured.

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "support/places.hpp"

extern char** environ;

namespace talus::test {

/// Waits until the condition is true; false after a time that is long for any machine.
template <class Condition>
bool comes_true(Condition&& condition) {
  constexpr std::chrono::minutes patience(10);
  const auto begin = std::chrono::steady_clock::now();
  while (!condition()) {
    if (std::chrono::steady_clock::now() - begin > patience) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

inline bool appears(const std::filesystem::path& file) {
  return comes_true([&] { return std::filesystem::exists(file); });
}

class Child {
 public:
  /// Starts the program, or the launcher `before` with the program as its arguments; the output goes to the file
  /// `said`.
  Child(const std::vector<std::string>& arguments, const std::filesystem::path& said,
        const std::vector<std::string>& before = {}) {
    std::vector<std::string> words = before;
    words.emplace_back(talus::places::program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    if (posix_spawnp(&process_, words.front().c_str(), &actions, nullptr, pointers.data(), environ) != 0) process_ = -1;
    posix_spawn_file_actions_destroy(&actions);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ <= 0) return;
    signal(SIGKILL);
    wait();
  }

  void signal(int which) const {
    if (process_ > 0) kill(process_, which);
  }
  /// The exit code, or 128 plus the signal that ended the program.
  int wait() {
    if (process_ <= 0) return -1;
    int status = 0;
    rusage usage{};
    wait4(process_, &status, 0, &usage);
    process_ = -1;
    peak_memory_ = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  /// After wait(): the peak of the resident memory [bytes].
  [[nodiscard]] std::size_t peak_memory() const { return peak_memory_; }

 private:
  pid_t process_ = -1;
  std::size_t peak_memory_ = 0;
};

}  // namespace talus::test
