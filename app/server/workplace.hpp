#pragma once
// The folder that is worked in. Names in requests are relative to it, and never lead out of it.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

/// Projects are looked for in the folder that is worked in, and in folders so many below it.
inline constexpr int deepest_project = 4;

class Workplace {
 public:
  explicit Workplace(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Tells it from others, also from one of the same path on another machine or at another time.
  [[nodiscard]] const std::string& identity() const { return identity_; }
  /// A file or folder below, there or not. Refuses (403) what would lead elsewhere, by dots or by links, and names of
  /// the system's or the server's own.
  [[nodiscard]] std::filesystem::path at(std::string_view name) const;
  /// The same of a file that must be there (404).
  [[nodiscard]] std::filesystem::path existing(std::string_view name) const;
  /// A project file, there or not: other files are not read or written as text (400).
  [[nodiscard]] std::filesystem::path project(std::string_view name) const;
  /// Where a file that `at` gave is written: the file that a link names, which is not replaced. Refuses (403) a link
  /// that leads out, also to what is not there yet.
  [[nodiscard]] std::filesystem::path written(const std::filesystem::path& file) const;

 private:
  std::filesystem::path folder_;
  std::string identity_;
};

}  // namespace talus::server
