#include "talus/files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* doing, int error) {
  const char* hint = error == ENOSPC || error == EDQUOT                    ? "Free some space, or write elsewhere"
                     : error == EACCES || error == EROFS || error == EPERM ? "Choose a folder that you may write to"
                     : error == EFBIG ? "Allow larger files (ulimit -f), or write elsewhere"
                                      : "Choose another folder";
  throw BadInput(Problem{.file = path.string(),
                         .what = fmt::format("cannot {}", doing),
                         .why = std::strerror(error),
                         .hint = hint,
                         .option = "-o"});
}

/// Some devices cannot be synchronised; it is enough that they accepted the data.
bool is_synchronised(int descriptor) { return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP; }

/// Opens the file itself, never the target of a link. Null on failure.
std::FILE* opened(const std::filesystem::path& path, int how, const char* mode) {
  constexpr mode_t mode_before_umask = 0666;
  const int descriptor = open(path.c_str(), how | O_NOFOLLOW | O_CLOEXEC, mode_before_umask);
  if (descriptor < 0) return nullptr;
  std::FILE* const file = fdopen(descriptor, mode);
  if (file == nullptr) close(descriptor);
  return file;
}

/// Makes a new name survive a power failure. Ignored where the system does not support it.
void synchronise_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)fsync(descriptor);
  close(descriptor);
}

}  // namespace

std::filesystem::path OutputFile::part_of(std::filesystem::path path) { return path += ".part"; }

OutputFile::OutputFile(std::filesystem::path path) : OutputFile(path, part_of(path)) {}

OutputFile::OutputFile(std::filesystem::path path, std::filesystem::path part)
    : path_(std::move(path)), part_(std::move(part)) {
  // Removes what a killed program left there, or a link or pipe that was put there to redirect the output.
  if (unlink(part_.c_str()) != 0 && errno == EISDIR) fail("create this file");
  file_ = opened(part_, O_WRONLY | O_CREAT | O_EXCL, "wb");
  if (file_ == nullptr) fail("create this file");
  set_buffer();
}

OutputFile::OutputFile(std::filesystem::path path, std::uint64_t bytes)
    : path_(std::move(path)), part_(part_of(path_)), position_(bytes), keeps_part_(true) {
  std::error_code ignored;
  if (!std::filesystem::exists(part_, ignored) && std::rename(path_.c_str(), part_.c_str()) != 0) {
    fail("continue this file");
  }
  const std::uintmax_t size = std::filesystem::file_size(part_, ignored);
  if (ignored || size < bytes) {
    throw BadInput(Problem{.file = part_.string(),
                           .what = "cannot continue this file",
                           .why = fmt::format("it has {} bytes, expected at least {}", ignored ? 0 : size, bytes)});
  }
  file_ = opened(part_, O_RDWR, "r+b");
  if (file_ == nullptr) fail("continue this file");
  set_buffer();
  if (ftruncate(fileno(file_), static_cast<off_t>(bytes)) != 0 || std::fseek(file_, 0, SEEK_END) != 0) {
    const int error = errno;
    std::fclose(file_);
    file_ = nullptr;
    refuse(path_, "continue this file", error);
  }
}

OutputFile::~OutputFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;
  if (!keeps_part_) std::filesystem::remove(part_, ignored);
}

void OutputFile::set_buffer() {
  constexpr std::size_t bytes = 1 << 18;
  buffer_ = std::make_unique_for_overwrite<char[]>(bytes);
  // (glibc ignores the size unless it is given a buffer.)
  std::setvbuf(file_, buffer_.get(), _IOFBF, bytes);
}

void OutputFile::fail(const char* doing) const { refuse(path_, doing, errno); }

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("write to this file");
  position_ += text.size();
}

void OutputFile::seek(std::uint64_t position) {
  if (fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail("write to this file");
  position_ = position;
}

void OutputFile::sync() {
  if (std::fflush(file_) != 0 || !is_synchronised(fileno(file_))) fail("write to this file");
}

void OutputFile::commit() {
  sync();
  const int closed = std::fclose(file_);
  file_ = nullptr;
  if (closed != 0 || std::rename(part_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    std::error_code ignored;
    if (!keeps_part_) std::filesystem::remove(part_, ignored);
    refuse(path_, "finish this file", error);
  }
  synchronise_folder_of(path_);
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

std::filesystem::path place_of_file(const std::filesystem::path& path) {
  if (const auto why = not_an_ordinary_file(path)) {
    throw BadInput(Problem{.file = path.string(),
                           .what = "cannot write this file",
                           .why = *why,
                           .hint = "Name an ordinary file, or one that does not exist yet"});
  }
  constexpr int most_links = 40;  // the limit of the system
  std::filesystem::path place = path;
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(place, error); ++links) {
    if (links == most_links) refuse(path, "write this file", ELOOP);
    const std::filesystem::path named = std::filesystem::read_symlink(place, error);
    if (error) refuse(path, "write this file", error.value());
    place = place.parent_path() / named;
  }
  return place;
}

void finish_file(const std::filesystem::path& part, const std::filesystem::path& path) {
  const int descriptor = open(part.c_str(), O_RDONLY | O_CLOEXEC);
  bool is_done = descriptor >= 0 && is_synchronised(descriptor);
  int error = errno;
  if (descriptor >= 0) close(descriptor);
  if (is_done) {
    is_done = std::rename(part.c_str(), path.c_str()) == 0;
    error = errno;
  }
  if (!is_done) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    refuse(path, "finish this file", error);
  }
  synchronise_folder_of(path);
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) refuse(to, "finish this file", errno);
}

void make_output_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) refuse(folder, "create this folder", error.value());
  if (!std::filesystem::is_directory(folder, error)) refuse(folder, "write results here", ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(folder, "write to this folder", errno);
}

}  // namespace talus
