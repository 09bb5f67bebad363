#include <fmt/format.h>

#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/verification/cases.hpp"

namespace talus::verification {

Files cases_in(const std::filesystem::path& folder) {
  std::error_code error;
  const auto refuse = [&](std::string what) {
    throw BadInput(Problem{.file = folder.string(), .where = {}, .what = std::move(what),
                           .why = "expected a folder that holds one folder a case, each with a case.toml",
                           .hint = "Leave --cases out to run the cases that are built in"});
  };
  if (!std::filesystem::is_directory(folder, error)) refuse("this is no folder");
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (!entry.is_directory()) continue;
    for (const auto& file : std::filesystem::directory_iterator(entry.path())) {
      const std::filesystem::path& path = file.path();
      if (path.extension() != ".toml" && path.extension() != ".csv") continue;
      files.emplace(fmt::format("{}/{}", entry.path().filename().string(), path.filename().string()),
                    project::text_of_file(path));
    }
  }
  if (error) refuse(fmt::format("the folder cannot be read: {}", error.message()));
  if (case_names(files).empty()) refuse("there is no case in it");
  return files;
}

}  // namespace talus::verification
