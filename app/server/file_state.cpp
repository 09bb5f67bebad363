#include "file_state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace talus::server {

namespace fs = std::filesystem;

std::optional<std::string> state_of_file(const fs::path& file) {
  std::error_code error;
  const std::string name = file.string();
  if (!fs::is_regular_file(file, error) || name.starts_with("/vsi") || file.extension() == ".vrt") return std::nullopt;
  const std::string stem = file.stem().string() + '.';
  std::vector<std::string> states;
  for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path(), error)) {
    const std::string sibling = entry.path().filename().string();
    if (!sibling.starts_with(stem)) continue;
    std::error_code ignored;
    states.push_back(fmt::format("{} {} {}", sibling, entry.file_size(ignored),
                                 entry.last_write_time(ignored).time_since_epoch().count()));
  }
  if (error) return std::nullopt;
  std::sort(states.begin(), states.end());
  return fmt::format("{}\n{}\n", name, fmt::join(states, "\n"));
}

}  // namespace talus::server
