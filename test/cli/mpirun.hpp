#pragma once
// The program as several processes that mpirun starts.

#include <sys/types.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace talus::test {

inline bool has_mpirun() { return std::system("command -v mpirun >/dev/null 2>&1") == 0; }

/// What stands before the program: works for root, on fewer cores than ranks, and without a network.
inline std::vector<std::string> mpirun(int ranks) {
  std::vector<std::string> words{"mpirun",
                                 "--allow-run-as-root",
                                 "--oversubscribe",
                                 "--bind-to",
                                 "none",
                                 "--mca",
                                 "btl",
                                 "self,vader",
                                 "--mca",
                                 "btl_vader_single_copy_mechanism",
                                 "none",
                                 "-n",
                                 std::to_string(ranks)};
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  // MPI itself is not instrumented, and keeps memory to its end.
  words.insert(words.end(), {"env", "ASAN_OPTIONS=detect_leaks=0", "TSAN_OPTIONS=ignore_noninstrumented_modules=1"});
#endif
  return words;
}

/// Processes whose command has this word: the one that mpirun starts is no child of the one that starts mpirun.
inline std::vector<pid_t> processes_with(const std::string& word) {
  std::vector<pid_t> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    std::ifstream in(entry.path() / "cmdline", std::ios::binary);
    const std::string command{std::istreambuf_iterator<char>(in), {}};
    const int number = std::atoi(entry.path().filename().c_str());
    if (number > 0 && command.find(word) != std::string::npos) found.push_back(number);
  }
  return found;
}

}  // namespace talus::test
