#include "talus/calibration/calibrate_models.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "talus/calibration/model_scores.hpp"
#include "talus/files/output_file.hpp"

namespace talus::calibration {

std::optional<HeldOutScore> held_out_score(const CalibrationResult& result) {
  HeldOutScore sum;
  double count = 0;
  for (const HeldOut& held : result.held_out) {
    const auto n = static_cast<double>(held.observations);
    sum.posterior += n * held.posterior;
    sum.prior += n * held.prior;
    count += n;
  }
  if (count == 0) return std::nullopt;
  return HeldOutScore{sum.posterior / count, sum.prior / count};
}

std::filesystem::path usual_folder(const Study& study) { return study.file.parent_path() / study.name; }

std::string calibrate_models_into(
    const std::filesystem::path& folder, const Study& study,
    const std::function<CalibrationResult(const StudyModel& model, const std::filesystem::path& folder)>& calibrate) {
  make_output_folder(folder);
  std::vector<ModelFacts> models;
  std::vector<std::vector<HeldOut>> held_out;
  for (const StudyModel& model : study.models) {
    const std::string name = fmt::format("model-{}", models.size() + 1);
    CalibrationResult result = calibrate(model, folder / name);
    models.push_back({model.name, name, held_out_score(result).value_or(HeldOutScore{}).prior, result.effective_sets});
    held_out.push_back(std::move(result.held_out));
  }
  const std::vector<ModelScore> scores = compare_models(held_out, study.seed);
  const std::string table = models_table(models, scores);
  write_file(folder / "models.csv", table);
  write_file(folder / "pooled.csv", pooled_table(pooled(held_out, scores)));
  return table;
}

}  // namespace talus::calibration
