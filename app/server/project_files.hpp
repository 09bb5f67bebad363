#pragma once
// Renaming, deleting and restoring projects, with what belongs to them: the file, its draft, the folder of its runs and
// its picture, and the study files beside it that name it.

#include <string>
#include <vector>

#include "run_store.hpp"
#include "workplace.hpp"

namespace talus::server {

/// A deleted project, in the hidden folder `.talus-deleted/ID` of the folder that is served.
struct DeletedProject {
  std::string id;
  std::string file;  // its name before, relative to the folder that is served
  std::string when;  // ISO 8601, UTC
  std::size_t runs = 0;
};

/// All functions may be called by any thread, and either do all of their work or none. They refuse (409) what belongs
/// to a run that is waiting or running, and to replace other files.
class ProjectFiles {
 public:
  ProjectFiles(const Workplace& workplace, RunStore& runs) : workplace_(workplace), runs_(runs) {}

  /// Gives a project another name in its folder, and returns its new name relative to the folder that is served.
  std::string rename(const std::string& file, const std::string& name);
  /// Moves a project to the deleted ones.
  DeletedProject remove(const std::string& file);
  /// Newest first.
  [[nodiscard]] std::vector<DeletedProject> deleted() const;
  /// Returns the project to its place.
  std::string restore(const std::string& id);
  /// Deletes for good.
  void erase(const std::string& id);

 private:
  [[nodiscard]] DeletedProject deleted_of(const std::string& id) const;
  [[nodiscard]] std::filesystem::path place_of_deleted(const std::string& id) const;

  const Workplace& workplace_;
  RunStore& runs_;
};

}  // namespace talus::server
