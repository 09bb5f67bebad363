#include "talus/project/problem_paths.hpp"

#include <algorithm>

#include "talus/project/document.hpp"

namespace talus::project {

namespace {

/// The path of the table, or of the list entry at the beginning of `what`, as in "polylines[2] crosses itself".
std::string entry_of(const toml::table& root, std::string_view key, std::string_view what) {
  const toml::table* table = root.get(key)->as_table();
  std::string path = SettingPaths::below("", key);
  const std::string_view name = what.substr(0, what.find(' '));
  const std::size_t open = name.find('[');
  if (table == nullptr || open == std::string_view::npos || !name.ends_with(']')) return path;
  const std::string_view number = name.substr(open + 1, name.size() - open - 2);
  if (!table->contains(name.substr(0, open)) || number.find_first_not_of("0123456789") != std::string_view::npos)
    return path;
  return SettingPaths::below(SettingPaths::below(std::move(path), name.substr(0, open)), number);
}

std::string path_of(const Problem& problem, const SettingPaths& paths, const toml::table& root,
                    const std::filesystem::path& file) {
  if (problem.file == file.string() || problem.file.empty()) {
    if (problem.line > 0) return paths.on_line(static_cast<std::uint32_t>(problem.line));
    std::string_view table = problem.where;
    const bool is_table = table.starts_with('[') && table.ends_with(']');
    if (is_table) table = table.substr(1, table.size() - 2);
    if (is_table && !root.contains(table)) return SettingPaths::below("", table);
    return root.contains(table) ? entry_of(root, table, problem.what) : std::string();
  }
  // As given in the setting, or preceded by the project's folder.
  if (std::string path = paths.of_text(problem.file); !path.empty()) return path;
  const std::string folder = file.parent_path().string() + '/';
  return problem.file.starts_with(folder) ? paths.of_text(problem.file.substr(folder.size())) : std::string();
}

}  // namespace

Problems with_paths(const Problems& problems, std::string_view text, const std::filesystem::path& file) {
  const auto& list = problems.list();
  if (std::all_of(list.begin(), list.end(), [](const Problem& problem) { return !problem.path.empty(); }))
    return problems;
  try {
    const Document document(text, file.string());
    const SettingPaths paths(document.root());
    Problems located;
    for (Problem problem : list) {
      if (problem.path.empty()) problem.path = path_of(problem, paths, document.root(), file);
      located.add(std::move(problem));
    }
    return located;
  } catch (const BadInput&) {  // not TOML: there are no settings
    return problems;
  }
}

}  // namespace talus::project
