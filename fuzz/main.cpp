// One fuzz target, chosen while compiling: TALUS_FUZZ_TARGET is the name of its function in targets.hpp.

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "targets.hpp"

namespace {

/// A folder for this process, in memory if the machine has /dev/shm.
std::filesystem::path own_folder() {
  const std::filesystem::path memory = "/dev/shm";
  std::string name =
      ((std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) / "talus-fuzz-XXXXXX")
          .string();
  if (::mkdtemp(name.data()) == nullptr) ::abort();
  return name;
}

struct Folder {
  std::filesystem::path path = own_folder();
  Folder() = default;
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  (void)talus::fuzz::TALUS_FUZZ_TARGET({reinterpret_cast<const char*>(data), size}, folder.path);
  return 0;
}
