// Calibrations and sensitivity studies, from their files into folders.

#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>

#include "bindings.hpp"
#include "problems.hpp"
#include "progress.hpp"
#include "talus/calibration/calibrate_models.hpp"
#include "talus/calibration/result_files.hpp"
#include "talus/sensitivity/output.hpp"

namespace talus::python {

namespace {

using Path = std::filesystem::path;

/// Does the work. Throws what interrupts it: what is finished is in the folder.
void do_and_report(const std::function<void()>& work, const Course& course, const Progress& progress) {
  const std::exception_ptr interruption = do_and_tell([&](const std::atomic<bool>&) { work(); }, course, progress);
  if (interruption) std::rethrow_exception(interruption);
}

calibration::CalibrationResult calibrate_one(const calibration::Study& study, const calibration::StudyModel* model,
                                             const Path& folder, int threads, Course& course, Problems& warnings) {
  const calibration::PreparedStudy prepared(study, model, warnings);
  const calibration::FolderOptions how{.threads = threads, .progress = [&](std::size_t done, std::size_t all) {
                                         course.planned = all;
                                         course.done = done;
                                       }};
  calibration::CalibrationResult result = calibration::calibrate_into(folder, prepared, how);
  warnings.append(result.warnings);
  return result;
}

/// The folder, the names of the study's models and the warnings.
py::tuple calibrate(const Path& file, const std::optional<Path>& into, int threads, const Progress& progress) {
  Course course;
  Problems warnings;
  Path folder;
  std::vector<std::string> models;
  do_and_report(
      [&] {
        const auto [study, doubts] = calibration::read_study(file);
        warnings = doubts;
        folder = into ? *into : calibration::usual_folder(study);
        if (study.models.empty()) {
          static_cast<void>(calibrate_one(study, nullptr, folder, threads, course, warnings));
          return;
        }
        for (const calibration::StudyModel& model : study.models) models.push_back(model.name);
        calibration::calibrate_models_into(folder, study, [&](const calibration::StudyModel& model, const Path& own) {
          return calibrate_one(study, &model, own, threads, course, warnings);
        });
      },
      course, progress);
  return py::make_tuple(folder, models, as_python(warnings));
}

/// The folder and the warnings.
py::tuple sensitivity(const Path& file, const std::optional<Path>& into, int threads, const Progress& progress) {
  Course course;
  Problems warnings;
  Path folder;
  do_and_report(
      [&] {
        const auto [study, doubts] = sensitivity::read_study(file);
        warnings = doubts;
        folder = into ? *into : sensitivity::usual_folder(study);
        const sensitivity::PreparedStudy prepared(study, warnings);
        course.planned = prepared.runs() * study.sites.size();
        const sensitivity::Analysis analysis = sensitivity::analyse_into(
            folder, study, prepared, {.threads = threads, .progress = [&](std::uint64_t done) { course.done = done; }});
        warnings.append(analysis.warnings);
      },
      course, progress);
  return py::make_tuple(folder, as_python(warnings));
}

}  // namespace

void bind_studies(py::module_& module) {
  module.def("calibrate", &calibrate, py::arg("file"), py::arg("folder"), py::arg("threads"), py::arg("progress"));
  module.def("sensitivity", &sensitivity, py::arg("file"), py::arg("folder"), py::arg("threads"), py::arg("progress"));
}

}  // namespace talus::python
