#include "earlier_output.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "talus/core/problems.hpp"

namespace talus::cli {

void refuse_other_files(const std::filesystem::path& file, std::string_view beginning, std::string_view kind) {
  std::ifstream stream(file, std::ios::binary);
  std::string found(beginning.size(), '\0');
  stream.read(found.data(), static_cast<std::streamsize>(found.size()));
  found.resize(static_cast<std::size_t>(stream.gcount()));
  if (found.empty() || found == beginning) return;
  throw BadInput(
      Problem{.file = file.string(),
              .what = "this file already exists",
              .why = fmt::format("it is not a {} written by this command, and only those are replaced", kind),
              .hint = "Choose another name"});
}

}  // namespace talus::cli
