#include "draft.hpp"

#include <string_view>
#include <system_error>

#include "talus/io/output_file.hpp"
#include "talus/project/document.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view opening = "# A draft of the file with the checksum ";

fs::path place_of(const fs::path& file) { return file.parent_path() / ("." + file.filename().string() + ".draft"); }

}  // namespace

std::optional<Draft> draft_of(const fs::path& file) {
  const fs::path place = place_of(file);
  std::error_code ignored;
  if (!fs::is_regular_file(place, ignored)) return std::nullopt;
  const std::string whole = project::text_of_file(place);
  const std::size_t end = whole.find('\n');
  if (!whole.starts_with(opening) || end == std::string::npos) return Draft{.text = whole, .saved = {}};
  return Draft{.text = whole.substr(end + 1), .saved = whole.substr(opening.size(), end - opening.size())};
}

void keep_draft(const fs::path& file, const Draft& draft) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  OutputFile kept(place_of(file));
  if (draft.saved) kept.write(std::string(opening) + *draft.saved + "\n");
  kept.write(draft.text);
  kept.commit();
}

void remove_draft(const fs::path& file) {
  std::error_code ignored;
  fs::remove(place_of(file), ignored);
}

}  // namespace talus::server
