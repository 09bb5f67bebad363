#include "talus/calibration/experiments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "talus/calibration/experiment.hpp"
#include "talus/core/nearest.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/output_file.hpp"

namespace talus::validation {

std::vector<std::string> experiment_names() {
  std::vector<std::string> names;
  for (const ExperimentFile& file : experiment_files()) {
    const std::size_t slash = file.path.find('/');
    if (slash != std::string_view::npos && file.path.substr(slash + 1) == experiment_file) {
      names.emplace_back(file.path.substr(0, slash));
    }
  }
  return names;
}

std::vector<std::string> chosen_experiments(const std::vector<std::string>& words) {
  const std::vector<std::string> names = experiment_names();
  if (words.empty()) return names;
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::set<std::string> chosen;
  Problems problems;
  for (const std::string& word : words) {
    const auto begins = [&](const std::string& name) { return !word.empty() && name.starts_with(word); };
    if (std::ranges::none_of(names, begins)) {
      const auto near = nearest(word, known);
      problems.add({.where = "validate",
                    .what = fmt::format("there is no experiment \"{}\"", word),
                    .why = fmt::format("built in: {}", fmt::join(names, ", ")),
                    .hint = near ? fmt::format("Did you mean \"{}\"?", *near)
                                 : fmt::format("Name one of these, or a folder with {}", experiment_file)});
    }
    for (const std::string& name : names) {
      if (begins(name)) chosen.insert(name);
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  return {chosen.begin(), chosen.end()};
}

void unpack(const std::string& experiment, const std::filesystem::path& folder) {
  make_output_folder(folder);
  const std::string beginning = experiment + "/";
  for (const ExperimentFile& file : experiment_files()) {
    if (!file.path.starts_with(beginning)) continue;
    OutputFile output(folder / file.path.substr(beginning.size()));
    output.write(file.bytes);
    output.commit();
  }
}

}  // namespace talus::validation
