#include "talus/files/ordinary_file.hpp"

#include <system_error>

namespace talus {

namespace fs = std::filesystem;

std::optional<std::string> not_an_ordinary_file(const fs::path& path) {
  std::error_code error;
  switch (fs::status(path, error).type()) {
    case fs::file_type::directory:
      return "it is a folder";
    case fs::file_type::fifo:
      return "it is a pipe";
    case fs::file_type::socket:
      return "it is a socket";
    case fs::file_type::character:
    case fs::file_type::block:
      return "it is a device";
    default:
      return std::nullopt;
  }
}

}  // namespace talus
