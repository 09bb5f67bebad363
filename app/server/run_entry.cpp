#include "run_entry.hpp"

namespace talus::server {

void save_and_publish(Run& run, const std::filesystem::path& base, EventHub& events) {
  try {
    save(run);
  } catch (const BadInput& bad) {
    // A full disk: the run itself continues until it fails, and its state is known here in any case.
    for (const Json& problem : as_json(bad.problems())) run.problems.push_back(problem);
  }
  events.publish("run", run.id, json_of(run, base));
}

std::shared_ptr<PreparedCalibration> prepare_calibration(ModelReading& reading,
                                                         const calibration::StudyReading& study) {
  return *reading.read<std::shared_ptr<PreparedCalibration>>("", [study] {
    Problems warnings = study.warnings;
    calibration::PreparedStudy prepared(study.study, nullptr, warnings);
    return std::make_shared<PreparedCalibration>(PreparedCalibration{std::move(prepared), std::move(warnings)});
  });
}

std::shared_ptr<BuiltProject> build_for_run(ModelReading& reading, const std::string& text,
                                            const std::filesystem::path& file, const project::Overrides& overrides) {
  return *reading.read<std::shared_ptr<BuiltProject>>(
      "", [=] { return std::make_shared<BuiltProject>(build(text, file, overrides)); });
}

}  // namespace talus::server
