#pragma once
// What is wrong with a file that a project names, said where the project names it.

#include <filesystem>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Why a file to read is not opened: it is not there, or it is a link that leads out of the project's folder. A file
/// elsewhere is read where the project names it plainly, by an absolute path or with dots, so that whoever was given
/// the project sees it. Empty where it is there, or may be: what GDAL opens may be a folder, or lie in an archive, and
/// a project that is only a text has no folder.
[[nodiscard]] std::string why_unreadable(const Project& project, const std::filesystem::path& file);

/// A text in which files beside the project are called as the project calls them, whatever the path by which it was
/// named itself.
[[nodiscard]] std::string seen_from_project(std::string text, const Project& project);

/// Problems of files become problems of the row `where` ("[terrain]", `seeder "Cliff"`) that names them, with the file
/// after the key. Those of files that it does not name, or names more than once, stay as they are. What is said of the
/// row without a line gets that of the file that it mentions.
[[nodiscard]] Problems said_of_project(const Problems& problems, const Project& project, std::string_view where);

/// Does `work(problems, warnings)`, and adds what it reported to the two lists, said so; what it throws is said so
/// and goes on.
template <class Work>
auto naming_files(const Project& project, std::string_view where, Problems& problems, Problems& warnings,
                  const Work& work) {
  Problems own_problems, own_warnings;
  const auto pass_on = [&] {
    problems.append(said_of_project(own_problems, project, where));
    warnings.append(said_of_project(own_warnings, project, where));
  };
  try {
    auto result = work(own_problems, own_warnings);
    pass_on();
    return result;
  } catch (const BadInput& bad) {
    pass_on();
    throw BadInput(said_of_project(bad.problems(), project, where));
  }
}

}  // namespace talus::project
