#pragma once
// The results of a run where they lie, and what its summary.json names.

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

/// The run's folder, if it has results; refused (404) where it has none yet, or none that are whole.
[[nodiscard]] std::filesystem::path results_folder(const Run& run);

/// What its summary.json says. Throws BadInput where it is damaged, and refuses as above.
[[nodiscard]] RunFacts read_facts(const Run& run);

/// The settings with which it was thrown, every default filled in: of its text, which is there before any result.
/// Throws BadInput where this program no longer takes the text.
[[nodiscard]] Json settings_of(const Run& run, const std::filesystem::path& project_file);

/// Names in the order in which results number them; others that come up later are added behind.
class Names {
 public:
  Names() = default;
  explicit Names(const std::vector<std::string>& names) {
    for (const std::string& name : names) number(name);
  }
  /// Of two things of the same name, the first.
  std::uint32_t number(std::string_view name);
  /// Nothing of one that is not among them.
  [[nodiscard]] std::optional<std::uint32_t> find(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }

 private:
  std::vector<std::string> list_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

// The names of a run's seeders (empty: it has none), sources, and barriers and collectors, in its order.
[[nodiscard]] std::vector<std::string> seeders_of(const RunFacts& facts);
[[nodiscard]] std::vector<std::string> sources_of(const RunFacts& facts);
[[nodiscard]] std::vector<std::string> barriers_of(const RunFacts& facts);

}  // namespace talus::server
