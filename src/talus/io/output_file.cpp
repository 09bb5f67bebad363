#include "talus/io/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "talus/core/problems.hpp"

namespace talus {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* doing, int error) {
  const char* hint = error == ENOSPC || error == EDQUOT ? "Free some space, or write elsewhere with -o"
                     : error == EACCES || error == EROFS || error == EPERM
                         ? "Choose a folder that you may write to with -o"
                         : "Choose another output folder with -o";
  throw BadInput(Problem{
      .file = path.string(), .what = fmt::format("cannot {}", doing), .why = std::strerror(error), .hint = hint});
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  file_ = std::fopen(part_.c_str(), "wb");
  if (file_ == nullptr) fail("create this file");
  std::setvbuf(file_, nullptr, _IOFBF, 1 << 20);
}

OutputFile::~OutputFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void OutputFile::fail(const char* doing) const { refuse(path_, doing, errno); }

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("write to this file");
}

void OutputFile::commit() {
  if (std::fflush(file_) != 0 || fsync(fileno(file_)) != 0) {
    // Some devices cannot be synchronised; what matters is that the data were taken.
    if (errno != EINVAL && errno != ENOTSUP) fail("write to this file");
  }
  const int closed = std::fclose(file_);
  file_ = nullptr;
  if (closed != 0 || std::rename(part_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    refuse(path_, "finish this file", error);
  }
}

void make_output_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) refuse(folder, "create this folder", error.value());
  if (!std::filesystem::is_directory(folder)) refuse(folder, "write results here", ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(folder, "write to this folder", errno);
}

}  // namespace talus
