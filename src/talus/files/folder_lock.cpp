#include "talus/files/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "talus/core/problems.hpp"

namespace talus {

std::optional<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return FolderLock(-1);  // writing to the folder will report what is wrong with it
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return FolderLock(file);
  const bool is_taken = errno == EWOULDBLOCK;
  close(file);
  if (is_taken) return std::nullopt;
  return FolderLock(-1);
}

FolderLock::~FolderLock() {
  if (file_ >= 0) close(file_);
}

FolderLock lock_output_folder(const std::filesystem::path& folder) {
  if (auto lock = FolderLock::take(folder)) return std::move(*lock);
  throw BadInput(Problem{.file = folder.string(),
                         .what = "cannot write results here",
                         .why = "another program is writing results into this folder",
                         .hint = "Wait until it has ended, or write elsewhere",
                         .option = "-o"});
}

}  // namespace talus
