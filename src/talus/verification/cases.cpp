#include "talus/verification/cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/verification/fields.hpp"

namespace talus::verification {

std::vector<std::string> case_names(const Files& files) {
  constexpr std::string_view ending = "/case.toml";
  std::vector<std::string> names;
  for (const auto& [path, text] : files) {
    if (path.ends_with(ending)) names.push_back(path.substr(0, path.size() - ending.size()));
  }
  return names;
}

std::vector<std::string> chosen_cases(const Files& files, const std::vector<std::string>& words) {
  const std::vector<std::string> names = case_names(files);
  if (words.empty()) return names;
  Problems problems;
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::vector<bool> chosen(names.size(), false);
  for (const std::string& word : words) {
    bool found = false;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!names[k].starts_with(word)) continue;
      chosen[k] = found = true;
    }
    if (!found || word.empty()) {
      problems.add({.where = "verify",
                    .what = fmt::format("there is no case \"{}\"", word),
                    .why = fmt::format("the cases are {}", fmt::join(names, ", ")),
                    .hint = suggestion(word, known)});
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  std::vector<std::string> list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (chosen[k]) list.push_back(names[k]);
  }
  return list;
}

Files cases_in(const std::filesystem::path& folder) {
  std::error_code error;
  const auto refuse = [&](std::string what) {
    throw BadInput(Problem{.file = folder.string(),
                           .where = {},
                           .what = std::move(what),
                           .why = "expected a folder with one folder per case, each with a case.toml",
                           .hint = "Leave out --cases to run the built-in cases"});
  };
  if (!std::filesystem::is_directory(folder, error)) refuse("this is not a folder");
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
