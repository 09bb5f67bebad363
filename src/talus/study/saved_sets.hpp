#pragma once
// Results of finished sets on disk, so that a study can be continued. What a result consists of is up to the study.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::study {

class SavedSets {
 public:
  /// Makes the folder `sets` in the study's, and reads the results that were saved there under this fingerprint. Files
  /// of another study, or damaged ones, are removed. Throws BadInput if the folder cannot be made.
  SavedSets(const std::filesystem::path& folder, std::string fingerprint);

  [[nodiscard]] std::size_t size() const { return results_.size(); }
  /// As given to `save`; nullopt: none was saved.
  [[nodiscard]] std::optional<std::string_view> of(std::size_t set) const;
  /// Writes the results of consecutive sets to a file.
  void save(std::size_t first, const std::vector<std::string>& results) const;

 private:
  void read(const std::filesystem::path& file);

  std::filesystem::path folder_;
  std::string fingerprint_;
  std::map<std::size_t, std::string> results_;
};

}  // namespace talus::study
