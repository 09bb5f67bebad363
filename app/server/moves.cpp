#include "moves.hpp"

#include <fmt/format.h>

#include "talus/core/problems.hpp"

namespace talus::server {

namespace fs = std::filesystem;

Moves::~Moves() {
  for (auto move = done_.rbegin(); move != done_.rend(); ++move) {
    std::error_code ignored;
    fs::rename(move->second, move->first, ignored);
  }
}

void Moves::move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(from, error))) return;
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::rename(from, to, error);
  if (error) {
    throw BadInput(Problem{.file = from.string(),
                           .what = fmt::format("cannot be moved to {}", to.string()),
                           .why = error.message(),
                           .hint = "Nothing was changed"});
  }
  done_.emplace_back(from, to);
}

}  // namespace talus::server
