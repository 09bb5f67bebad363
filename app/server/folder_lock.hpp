#pragma once
// Whose a run's folder is while rocks are thrown there: servers that work in the same folder see each other's runs.

#include <filesystem>
#include <optional>

namespace talus::server {

/// Held until it goes, or the program does.
class FolderLock {
 public:
  /// Nothing where another has it.
  [[nodiscard]] static std::optional<FolderLock> take(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  FolderLock& operator=(FolderLock&&) = delete;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int file) : file_(file) {}
  int file_;
};

}  // namespace talus::server
