#pragma once
// A lock on a folder while results are written there, which keeps other programs from writing to it.

#include <filesystem>
#include <optional>

namespace talus {

/// Held until it is destroyed or the process ends, however it ends. Has no effect if the file system has no such locks
/// (some folders on NFS).
class FolderLock {
 public:
  /// nullopt if another process holds it.
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

/// Throws BadInput if another process holds it.
[[nodiscard]] FolderLock lock_output_folder(const std::filesystem::path& folder);

}  // namespace talus
