#include "talus/project/named_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace talus::project {

namespace {

bool is_same(const Project& project, const NamedFile& named, const std::string& file) {
  return named.file.string() == file || (project.file.parent_path() / named.file).string() == file;
}

const NamedFile* only_one(const Project& project, std::string_view where, const std::string& file) {
  const NamedFile* found = nullptr;
  for (const NamedFile& each : project.named_files) {
    if (each.where != where || !is_same(project, each, file)) continue;
    if (found != nullptr) return nullptr;
    found = &each;
  }
  return found;
}

/// The line at which this row names a file that is mentioned in the problem; 0 if none is.
int line_of_mentioned(const Project& project, std::string_view where, const Problem& problem) {
  for (const NamedFile& each : project.named_files) {
    if (each.where != where || each.named_in != project.file.string()) continue;
    const std::string name = fmt::format("\"{}\"", each.file.string());
    if (problem.what.find(name) != std::string::npos || problem.why.find(name) != std::string::npos) return each.line;
  }
  return 0;
}

/// The target of a path that appears to lie in the project's folder but is a link to outside it; nullopt otherwise.
std::optional<std::filesystem::path> target_outside(const Project& project, const std::filesystem::path& file) {
  const std::filesystem::path plain = file.lexically_normal();
  if (plain.is_absolute() || *plain.begin() == "..") return std::nullopt;
  std::error_code error;
  const auto folder = std::filesystem::canonical(std::filesystem::absolute(project.file).parent_path(), error);
  const auto real = std::filesystem::canonical(folder / plain, error);
  if (error) return std::nullopt;
  const bool is_below = std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
  return is_below ? std::nullopt : std::optional(real);
}

}  // namespace

std::string why_unreadable(const Project& project, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path path = project.file.parent_path() / file;
  if (!std::filesystem::exists(project.file, error) || path.string().starts_with("/vsi")) return "";
  if (std::filesystem::exists(path, error)) {
    const auto real = target_outside(project, file);
    return real ? fmt::format("it is a link to outside the project's folder; name {} itself", real->string()) : "";
  }
  if (error) return fmt::format("it cannot be accessed: {}", error.message());
  return "there is no such file";
}

std::string with_relative_paths(std::string text, const std::filesystem::path& folder) {
  const std::string start = (folder / "").string();
  if (start.empty()) return text;
  const auto begins_a_path = [&](std::size_t at) {
    constexpr std::string_view before = " \t\n\"'`(=:,<";
    return at == 0 || before.find(text[at - 1]) != std::string_view::npos;
  };
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at)) {
    if (begins_a_path(at)) {
      text.erase(at, start.size());
    } else {
      at += start.size();
    }
  }
  return text;
}

std::string name_in_problems(const Project& project, std::string_view table, std::string_view name, std::size_t index) {
  std::string by_name = fmt::format("{} \"{}\"", table, name);
  const bool is_named =
      std::ranges::any_of(project.named_files, [&](const NamedFile& file) { return file.where == by_name; });
  return is_named ? by_name : fmt::format("{} {}", table, index + 1);
}

Problems located_in_project(const Problems& problems, const Project& project, std::string_view where) {
  Problems located;
  for (Problem problem : problems.list()) {
    if (const NamedFile* named = only_one(project, where, problem.file)) {
      const std::string line = problem.line > 0 ? fmt::format(":{}", problem.line) : "";
      const std::string within = problem.where.empty() ? "" : problem.where + ": ";
      problem.what = fmt::format("{} {}{}: {}{}", named->key, problem.file, line, within, problem.what);
      problem.file = named->named_in;
      problem.line = named->line;
      problem.where = named->where;
      problem.path = named->path;
    } else if (problem.file == project.file.string() && problem.line == 0 && problem.where == where) {
      problem.line = line_of_mentioned(project, where, problem);
    }
    located.add(std::move(problem));
  }
  return located;
}

}  // namespace talus::project
