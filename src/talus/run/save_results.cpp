#include "talus/run/save_results.hpp"

#include <system_error>

#include "talus/archive/run_state.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/run/finished_run.hpp"
#include "talus/run/result_files.hpp"

namespace talus::project {

WrittenResults save_results(const std::filesystem::path& folder, const Project& project, const Model& model,
                            const RunDescription& description, RunSums& sums, const RunCourse& course,
                            const std::function<void(TableFiles&)>& write_rows) {
  check_that_inputs_are_kept(folder, project);
  make_output_folder(folder);
  const FolderLock lock = lock_output_folder(folder);
  check_that_results_have_room(folder, description, {});
  TableFiles tables(folder, TableContext::of(model), table_rocks(project, model.rocks()));
  std::error_code ignored;
  std::filesystem::remove(folder / run_state_name, ignored);  // of an earlier run
  tables.begin();
  write_rows(tables);
  remove_finished_summary(folder);
  tables.finish();
  return write_results(folder, description, sums, course);
}

}  // namespace talus::project
