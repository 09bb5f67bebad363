#pragma once
// Problems with files that a project names, reported at the line that names them.

#include <filesystem>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Why an input file is not opened: it does not exist, or it is a link to outside the project's folder. (Files
/// elsewhere must be named openly, by an absolute path or with `..`, so that anyone who receives the project can see
/// them.) Empty if it exists or may exist: GDAL can open folders and files in archives, and a project without a file
/// has no folder.
[[nodiscard]] std::string why_unreadable(const Project& project, const std::filesystem::path& file);

/// A text in which paths of files in a folder, which begin as `folder` does, are relative to it.
[[nodiscard]] std::string with_relative_paths(std::string text, const std::filesystem::path& folder);

/// The name of an entry of [[table]] in problems: by its name, or by its number if the file does not name it.
[[nodiscard]] std::string name_in_problems(const Project& project, std::string_view table, std::string_view name,
                                           std::size_t index);

/// Turns problems of files into problems of the row `where` ("[terrain]", `seeder "Cliff"`) that names them, with the
/// file after the key. Problems of files that the row does not name, or names more than once, are unchanged. A problem
/// of the row without a line gets the line of the file that it mentions.
[[nodiscard]] Problems located_in_project(const Problems& problems, const Project& project, std::string_view where);

/// Calls `work(problems, warnings)` and adds what it reports to the two lists, located in the project. A BadInput that
/// it throws is located likewise and rethrown.
template <class Work>
auto locating_problems(const Project& project, std::string_view where, Problems& problems, Problems& warnings,
                       const Work& work) {
  Problems own_problems, own_warnings;
  const auto report = [&] {
    problems.append(located_in_project(own_problems, project, where));
    warnings.append(located_in_project(own_warnings, project, where));
  };
  try {
    auto result = work(own_problems, own_warnings);
    report();
    return result;
  } catch (const BadInput& bad) {
    report();
    throw BadInput(located_in_project(bad.problems(), project, where));
  }
}

}  // namespace talus::project
