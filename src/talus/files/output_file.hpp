#pragma once
// Files that appear under their final names only when they are whole.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "talus/files/text_sink.hpp"

namespace talus {

/// Written as `NAME.part` beside its final place. Every failure (no permission, disk full) throws BadInput that names
/// the file; what is not committed is removed, unless it was to be kept.
class OutputFile : public TextSink {
 public:
  explicit OutputFile(std::filesystem::path path);
  /// Written as `part`, in the same folder: of a file that several may write at the same time each has one of its own.
  OutputFile(std::filesystem::path path, std::filesystem::path part);
  /// Goes on with what an earlier program left as `NAME.part`, or under the final name: its first `bytes` bytes, of
  /// which there must be so many; the rest is cut off.
  OutputFile(std::filesystem::path path, std::uint64_t bytes);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() override;

  void write(std::string_view text) override;
  /// What is written next stands so many bytes after the file's beginning; what lies between is to be written later.
  void seek(std::uint64_t position);
  /// Where the next byte will stand.
  [[nodiscard]] std::uint64_t position() const { return position_; }
  /// Everything written so far is on the disk afterwards.
  void sync();
  /// From now on the part stays if this is not committed.
  void keep_part() { keeps_part_ = true; }
  /// Flushes to the disk and renames to the final name.
  void commit();

  /// `NAME.part` of a final name.
  [[nodiscard]] static std::filesystem::path part_of(std::filesystem::path path);

 private:
  [[noreturn]] void fail(const char* doing) const;
  /// Of the file that has just been opened: gathers what is written to it.
  void gather();

  std::filesystem::path path_, part_;
  std::unique_ptr<char[]> gathered_;  // the file's own, until it is closed
  std::FILE* file_ = nullptr;
  std::uint64_t position_ = 0;
  bool keeps_part_ = false;
};

/// Where a single file that the user names is written, to be asked before the work: the file itself, or the one that a
/// link names, which is then not replaced. Throws BadInput where a folder, a device or the like has that name.
[[nodiscard]] std::filesystem::path place_of_file(const std::filesystem::path& path);

/// Of a file that another library has written as `part`: to the disk, and then to its final name. Throws BadInput where
/// that fails; the part is removed then.
void finish_file(const std::filesystem::path& part, const std::filesystem::path& path);

/// Gives a file another name, in the place of one that may have it; throws BadInput where that fails.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a folder, and those above it; throws BadInput if it cannot be made or written to.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace talus
