#pragma once
// The results of a run: their folder, the summary, and the names in it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "http/answer.hpp"
#include "run.hpp"
#include "talus/archive/run_facts.hpp"

namespace talus::server {

/// The run's folder. Refuses (404) a run without complete results.
[[nodiscard]] std::filesystem::path results_folder(const Run& run);

/// Reads summary.json. Throws BadInput if it is damaged, and refuses as results_folder().
[[nodiscard]] RunFacts read_facts(const Run& run);

/// The settings of the run with all defaults, from the project's text in its folder, which exists before any result.
/// Throws BadInput if this version of Talus no longer accepts the text.
[[nodiscard]] Json settings_of(const Run& run, const std::filesystem::path& project_file);

/// Names, numbered as in the results. Names that are not in the summary are appended.
class Names {
 public:
  Names() = default;
  explicit Names(const std::vector<std::string>& names) {
    for (const std::string& name : names) number(name);
  }
  /// The number of a name, which is appended if it is new. Of equal names, the first counts.
  std::uint32_t number(std::string_view name);
  /// nullopt for an unknown name.
  [[nodiscard]] std::optional<std::uint32_t> find(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }

 private:
  std::vector<std::string> list_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

// The names of a run's seeders (empty: unnamed), of its sources, and of its barriers and collectors, in their order.
[[nodiscard]] std::vector<std::string> seeders_of(const RunFacts& facts);
[[nodiscard]] std::vector<std::string> sources_of(const RunFacts& facts);
[[nodiscard]] std::vector<std::string> barriers_of(const RunFacts& facts);

}  // namespace talus::server
