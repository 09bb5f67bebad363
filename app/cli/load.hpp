#pragma once
// A project from its file to a model, for every command that needs one.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::cli {

/// A project file and options that override its settings.
struct ProjectOptions {
  std::filesystem::path file;
  std::vector<std::string> settings;
  std::optional<std::int64_t> rocks;
  std::optional<std::uint64_t> seed;
};

struct Loaded {
  project::Project project;
  Model model;
  Problems warnings;
};

/// Throws BadInput with all problems of the file or, if it has none, of the files that it names.
[[nodiscard]] Loaded load(const ProjectOptions& options);

/// If the run is large, prints the expected size of its results and its duration on `threads` threads. Setting `stop`
/// ends the estimate.
void print_if_large(const Loaded& loaded, const RockRange& rocks, int threads, const std::atomic<bool>* stop = nullptr);

/// To standard error, one a line.
void print_warnings(const Problems& warnings);

}  // namespace talus::cli
