#pragma once
// The experiments that are built into the program (validation/, cmake/embed_experiments.cmake).

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::validation {

struct ExperimentFile {
  std::string_view path;  // FOLDER/NAME
  std::string_view bytes;
};

/// Sorted by path.
[[nodiscard]] const std::vector<ExperimentFile>& experiment_files();

/// The folders that contain an experiment.toml, in order.
[[nodiscard]] std::vector<std::string> experiment_names();

/// The experiments whose names begin with one of the words; all without words. Throws BadInput, with the nearest name,
/// if a word matches none.
[[nodiscard]] std::vector<std::string> chosen_experiments(const std::vector<std::string>& words);

/// Writes the files of an experiment, with their licence, into a folder.
void unpack(const std::string& experiment, const std::filesystem::path& folder);

}  // namespace talus::validation
