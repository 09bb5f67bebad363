#pragma once
// Whose a folder is while results are written there, as programs that would write there see each other.

#include <filesystem>
#include <optional>

namespace talus {

/// Held until it goes, or the program does, however that ends. Where the file system has no such locks (folders on NFS)
/// it keeps nobody out.
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

/// Throws BadInput where another has it.
[[nodiscard]] FolderLock lock_output_folder(const std::filesystem::path& folder);

}  // namespace talus
