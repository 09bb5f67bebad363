#pragma once
// Files that appear under their final names only when they are complete.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "talus/files/text_sink.hpp"

namespace talus {

/// Written as `NAME.part` next to its final place. Every failure (no permission, disk full) throws BadInput with the
/// file's name. A file that is not committed is removed, unless its part is to be kept.
class OutputFile : public TextSink {
 public:
  explicit OutputFile(std::filesystem::path path);
  /// Written as `part`, in the same folder: processes that may write a file at the same time need distinct parts.
  OutputFile(std::filesystem::path path, std::filesystem::path part);
  /// Continues a file that an earlier program left as `NAME.part` or under its final name, after its first `bytes`
  /// bytes, which must exist; the rest is cut off.
  OutputFile(std::filesystem::path path, std::uint64_t bytes);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() override;

  void write(std::string_view text) override;
  /// Continues at this byte of the file; bytes that were skipped must be written later.
  void seek(std::uint64_t position);
  /// The position of the next byte.
  [[nodiscard]] std::uint64_t position() const { return position_; }
  /// Writes everything so far to the disk.
  void sync();
  /// Keeps the part from now on, even if it is not committed.
  void keep_part() { keeps_part_ = true; }
  /// Flushes to the disk and renames to the final name.
  void commit();

  /// `NAME.part` of a final name.
  [[nodiscard]] static std::filesystem::path part_of(std::filesystem::path path);

 private:
  [[noreturn]] void fail(const char* doing) const;
  /// Gives the file that has just been opened a large buffer.
  void set_buffer();

  std::filesystem::path path_, part_;
  std::unique_ptr<char[]> buffer_;  // used by the file until it is closed
  std::FILE* file_ = nullptr;
  std::uint64_t position_ = 0;
  bool keeps_part_ = false;
};

/// Writes a whole file as OutputFile does.
void write_file(const std::filesystem::path& path, std::string_view text);

/// The place to write a single file that the user names, to be checked before the work: the file itself, or the target
/// of a link, which is then not replaced. Throws BadInput if it is a folder, a device or the like.
[[nodiscard]] std::filesystem::path place_of_file(const std::filesystem::path& path);

/// Synchronises a file that another library has written as `part`, and renames it to its final name. Throws BadInput on
/// failure, and then removes the part.
void finish_file(const std::filesystem::path& part, const std::filesystem::path& path);

/// Renames a file, and replaces one that has the new name. Throws BadInput on failure.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Creates a folder and its parents. Throws BadInput if it cannot be created or written to.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace talus
