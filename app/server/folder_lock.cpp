#include "folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace talus::server {

std::optional<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return FolderLock(-1);  // whoever writes there will say what is wrong with it
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return FolderLock(file);
  close(file);
  return std::nullopt;
}

FolderLock::~FolderLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace talus::server
