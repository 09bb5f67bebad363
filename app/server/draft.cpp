#include "draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "talus/files/output_file.hpp"
#include "talus/project/document.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view opening = "# A draft of the file with the checksum ";
constexpr std::string_view lineage = "# Its last changes in each tab of the workbench: ";
constexpr std::size_t longest_tab = 32;

bool is_same(const Revision& a, const Revision& b) { return a.tab == b.tab && a.count == b.count; }

/// If the first line has this beginning, removes the line and returns its rest.
std::optional<std::string> take_line(std::string& text, std::string_view beginning) {
  const std::size_t end = text.find('\n');
  if (!text.starts_with(beginning) || end == std::string::npos) return std::nullopt;
  std::string rest = text.substr(beginning.size(), end - beginning.size());
  text.erase(0, end + 1);
  return rest;
}

std::vector<Revision> revisions_of(std::string_view line) {
  std::vector<Revision> revisions;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (const auto revision = revision_of(line.substr(0, end))) revisions.push_back(*revision);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return revisions;
}

}  // namespace

std::optional<Revision> revision_of(std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  Revision revision{.tab = std::string(text.substr(0, point))};
  const std::string_view count = text.substr(std::min(point + 1, text.size()));
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), revision.count);
  const bool is_name = !revision.tab.empty() && revision.tab.size() <= longest_tab &&
                       std::ranges::all_of(revision.tab, [](unsigned char c) { return std::isalnum(c) != 0; });
  if (!is_name || error != std::errc() || end != count.data() + count.size()) return std::nullopt;
  return revision;
}

std::string text_of(const Revision& revision) { return fmt::format("{}.{}", revision.tab, revision.count); }

bool continues(const Draft& draft, const std::optional<Revision>& after, const Revision& next) {
  if (draft.revisions.empty()) return !after;
  const Revision& last = draft.revisions.back();
  return (after && is_same(last, *after)) || (last.tab == next.tab && last.count < next.count);
}

std::vector<Revision> with_revision(std::vector<Revision> revisions, const Revision& next) {
  std::erase_if(revisions, [&](const Revision& old) { return old.tab == next.tab; });
  revisions.push_back(next);
  return revisions;
}

std::mutex& project_writing() {
  static std::mutex mutex;
  return mutex;
}

fs::path draft_place(const fs::path& file) { return file.parent_path() / ("." + file.filename().string() + ".draft"); }

std::optional<Draft> draft_of(const fs::path& file) {
  const fs::path place = draft_place(file);
  std::error_code ignored;
  if (!fs::is_regular_file(place, ignored)) return std::nullopt;
  Draft draft{.text = project::text_of_file(place), .saved = {}};
  draft.saved = take_line(draft.text, opening);
  if (const auto line = take_line(draft.text, lineage)) draft.revisions = revisions_of(*line);
  return draft;
}

void save_draft(const fs::path& file, const Draft& draft) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  OutputFile kept(draft_place(file));
  if (draft.saved) kept.write(fmt::format("{}{}\n", opening, *draft.saved));
  if (!draft.revisions.empty()) {
    std::string line;
    for (const Revision& revision : draft.revisions) line += (line.empty() ? "" : " ") + text_of(revision);
    kept.write(fmt::format("{}{}\n", lineage, line));
  }
  kept.write(draft.text);
  kept.commit();
}

void remove_draft(const fs::path& file) {
  std::error_code ignored;
  fs::remove(draft_place(file), ignored);
}

}  // namespace talus::server
