#pragma once
// Files that appear under their final names only when they are whole.

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace talus {

/// Written as `NAME.part` beside its final place. Every failure (no permission, disk full) throws BadInput that names
/// the file; what is not committed is removed.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  /// Flushes to the disk and renames to the final name.
  void commit();

 private:
  [[noreturn]] void fail(const char* doing) const;

  std::filesystem::path path_, part_;
  std::FILE* file_ = nullptr;
};

/// Makes a folder, and those above it; throws BadInput if it cannot be made or written to.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace talus
