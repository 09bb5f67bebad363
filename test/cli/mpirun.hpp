#pragma once
// The program as several processes started by mpirun.

#include <sys/types.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/places.hpp"

namespace talus::test {

inline bool has_mpirun() { return std::system("command -v mpirun >/dev/null 2>&1") == 0; }

/// NAME=value: options of the sanitizers for a program that calls MPI, which is not instrumented.
inline std::vector<std::string> environment_of_mpi() {
#if defined(__SANITIZE_ADDRESS__)
  // Whole stacks, through code without frame pointers: suppressions match MPI's leaks by their callers.
  return {"ASAN_OPTIONS=fast_unwind_on_malloc=0:malloc_context_size=50",
          "LSAN_OPTIONS=print_suppressions=0:suppressions=" + talus::places::in_source("/cmake/asan/suppressions")};
#elif defined(__SANITIZE_THREAD__)
  return {"TSAN_OPTIONS=ignore_noninstrumented_modules=1:suppressions=" +
          talus::places::in_source("/cmake/tsan/suppressions")};
#else
  return {};
#endif
}

/// The words before the program: work for root, on fewer cores than ranks, and without a network.
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
  words.emplace_back("env");
  const std::vector<std::string> environment = environment_of_mpi();
  words.insert(words.end(), environment.begin(), environment.end());
  return words;
}

/// Processes with this word in their command line. (The ranks are not children of the process that starts mpirun.)
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
