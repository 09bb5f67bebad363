#pragma once
// The folder that is served. Names in requests are relative to it, and never lead out of it.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

/// Projects are searched for in the folder that is served and this many levels below it.
inline constexpr int deepest_project = 4;

/// The ending of the names of study files, which tells them from projects.
inline constexpr const char* study_ending = ".study.toml";

class Workplace {
 public:
  explicit Workplace(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Differs between folders, even between folders of the same path on different machines or at different times.
  [[nodiscard]] const std::string& identity() const { return identity_; }
  /// The path of a file or folder below, which need not exist. Refuses (403) names that lead elsewhere, by dots or by
  /// links, and hidden names.
  [[nodiscard]] std::filesystem::path at(std::string_view name) const;
  /// As at(), for a file that must exist (404).
  [[nodiscard]] std::filesystem::path existing(std::string_view name) const;
  /// As at(), for a project file: no other files are read or written as text (400).
  [[nodiscard]] std::filesystem::path project(std::string_view name) const;
  /// Where a file from at() is written: links are followed, not replaced. Refuses (403) a link that leads out of the
  /// folder, even if its target does not exist yet.
  [[nodiscard]] std::filesystem::path written(const std::filesystem::path& file) const;

 private:
  std::filesystem::path folder_;
  std::string identity_;
};

}  // namespace talus::server
