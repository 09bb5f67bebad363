#pragma once
// A temporary folder for the input files of one test, and what their readers report.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "talus/core/problems.hpp"

namespace talus::testing_tools {

class InputFolder : public ::testing::Test {
 protected:
  InputFolder() {
    const auto* const info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path{::testing::TempDir()} /
              ("talus_" + std::string{info->name()} + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~InputFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  /// A message without the path of the folder, which differs between runs.
  [[nodiscard]] std::string without_folder(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) text.erase(at, prefix.size());
    return text;
  }

  /// The message of the BadInput that `work` throws, or "was read".
  template <class Work>
  [[nodiscard]] std::string refusal_of(Work&& work) const {
    try {
      work();
    } catch (const BadInput& error) {
      return without_folder(error.what());
    }
    return "was read";
  }

  [[nodiscard]] std::string warnings() const { return without_folder(warnings_.text()); }

  std::filesystem::path folder_;
  Problems warnings_;  // of the last reading
};

}  // namespace talus::testing_tools
