#include "study_references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "run.hpp"
#include "talus/project/document.hpp"
#include "workplace.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

std::string toml_quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

/// The beginning of a line of the text, counted from 1.
std::size_t begin_of_line(const std::string& text, std::size_t line) {
  std::size_t at = 0;
  for (std::size_t k = 1; k < line; ++k) at = text.find('\n', at) + 1;
  return at;
}

/// Replaces the name of a project in the line of a value, whatever quotes it has there.
void replace_name(std::string& text, std::size_t line, const fs::path& study, const std::string& from,
                  const std::string& to) {
  const std::size_t begin = begin_of_line(text, line), end = std::min(text.find('\n', begin), text.size());
  for (const std::string& written : std::array{toml_quoted(from), "'" + from + "'", toml_quoted("./" + from)}) {
    const std::size_t found = text.find(written, begin);
    if (found == std::string::npos || found + written.size() > end) continue;
    text.replace(found, written.size(), toml_quoted(to));
    return;
  }
  throw BadInput(Problem{.file = study.string(),
                         .line = static_cast<int>(line),
                         .what = fmt::format("names {} in a way that cannot be replaced", from),
                         .hint = fmt::format("Write project = {} there, then rename the project", toml_quoted(from))});
}

std::optional<StudyReference> reference_in(const fs::path& study, const std::string& from, const std::string& to) {
  StudyReference found{.file = study, .text = project::text_of_file(study), .renamed = {}};
  std::vector<std::size_t> lines;
  try {
    const project::Document document(found.text, study.string());
    const toml::array* sites = document.root()["site"].as_array();
    for (std::size_t k = 0; sites != nullptr && k < sites->size(); ++k) {
      const toml::table* site = (*sites)[k].as_table();
      const toml::value<std::string>* name = site ? (*site)["project"].as_string() : nullptr;
      if (name && fs::path(name->get()).lexically_normal() == from) lines.push_back(name->source().begin.line);
    }
  } catch (const BadInput&) {
    return std::nullopt;  // it is no study that runs
  }
  if (lines.empty()) return std::nullopt;
  found.renamed = found.text;
  for (const std::size_t line : lines) replace_name(found.renamed, line, study, from, to);
  return found;
}

}  // namespace

std::vector<StudyReference> study_references(const fs::path& folder, const std::string& from, const std::string& to,
                                             const std::vector<fs::path>& calibrations) {
  std::vector<fs::path> studies;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    if (name.ends_with(study_ending) && !name.starts_with('.') && entry->is_regular_file(ignored))
      studies.push_back(entry->path());
  }
  std::sort(studies.begin(), studies.end());
  for (const fs::path& run : calibrations) studies.push_back(run / run_study_name);
  std::vector<StudyReference> found;
  for (const fs::path& study : studies)
    if (auto reference = reference_in(study, from, to)) found.push_back(std::move(*reference));
  return found;
}

}  // namespace talus::server
