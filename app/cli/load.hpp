#pragma once
// A project from its file to a model, for every command that needs one.

#include <atomic>

#include "commands.hpp"
#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::cli {

struct Loaded {
  project::Project project;
  Model model;
  Problems warnings;
};

/// Throws BadInput with every problem of the file; or, if the file is sound, of what it refers to.
[[nodiscard]] Loaded load(const ProjectOptions& options);

/// How large a run of these rocks will be and how long it will take on so many threads, where it is large. `stop`, once
/// it is set, ends the estimate.
void print_if_large(const Loaded& loaded, const RockRange& rocks, int threads, const std::atomic<bool>* stop = nullptr);

/// To standard error, one a line.
void print_warnings(const Problems& warnings);

}  // namespace talus::cli
