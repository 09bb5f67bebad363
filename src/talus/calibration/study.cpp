#include "talus/calibration/study.hpp"

#include <fmt/format.h>

#include "talus/core/utf8.hpp"
#include "talus/project/document.hpp"

namespace talus::calibration {

namespace {

/// The rules across several keys.
class StudyCheck {
 public:
  StudyCheck(Study& study, study::StudyProblems& problems) : study_(study), problems_(problems) {}

  void check() {
    problems_.check_names("observations", study_.observations);
    problems_.check_names("model", study_.models);
    for (std::size_t k = 0; k < study_.observations.size(); ++k) check_observations(k);
    if (study_.folds == 1) {
      problems_.refuse("", 0, "folds", "folds is 1", "nothing would be left to learn from",
                       "Use 0 for none, or 2 or more");
    }
    if (study_.hold_out_sites && study_.sites.size() < 2) {
      problems_.refuse("", 0, "hold_out_sites", "hold_out_sites is true", "the study has only one site", "");
    }
    if (study_.models.size() == 1) {
      problems_.refuse("model", 0, "", "there is only one [[model]]", "models are compared with each other",
                       "Add another, or give its settings to the sites");
    }
    if (study_.models.size() > 1 && study_.folds == 0 && !study_.hold_out_sites) {
      problems_.refuse("model", 0, "", "models are compared by what they predict", "the study has no folds",
                       "Write folds = 5");
    }
  }

 private:
  void check_observations(std::size_t k) {
    constexpr const char* table = "observations";
    StudyObservations& each = study_.observations[k];
    if (each.site.empty() && study_.sites.size() == 1) each.site = study_.sites.front().name;
    if (each.site.empty() && !study_.sites.empty()) {
      problems_.refuse(table, k, "site", "site is missing", "the study has several sites", "");
    } else if (!each.site.empty()) {
      problems_.check_site_name(table, k, "site", each.site, study_);
    }
    const bool has_file = !each.file().empty();
    if (!has_file && !problems_.is_refused(table, k, "stops") && !problems_.is_refused(table, k, "marks") &&
        !problems_.is_refused(table, k, "values") && !problems_.is_refused(table, k, "zones")) {
      problems_.refuse(table, k, "", "stops, marks, values or zones is missing", "observations come from a file",
                       "Write stops = \"stops.csv\"");
    }
    if (!each.values.empty() && each.at.empty() && !problems_.is_refused(table, k, "at")) {
      problems_.refuse(table, k, "values", "at is missing",
                       "values are observed at a collector or barrier of the project", "");
    }
    if (each.values.empty() && has_file && !each.at.empty()) {
      problems_.refuse(table, k, "at", "at is given without values", "only values have a line", "Leave it out");
    }
    for (const char* key : {"released", "blocks", "relative_accuracy"}) {
      if (!each.zones.empty() || !has_file || !problems_.is_given(table, k, key)) continue;
      problems_.refuse(table, k, key, fmt::format("{} is given without zones", key), "only deposits by zone have it",
                       "Leave it out");
    }
    if (each.name.empty()) each.name = as_utf8(each.file().stem().string());
  }

  Study& study_;
  study::StudyProblems& problems_;
};

}  // namespace

StudyReading read_study_text(std::string_view text, const std::filesystem::path& file) {
  StudyReading reading;
  Study& study = reading.study;
  const auto row = [&](std::string_view table, int line) -> project::Row {
    if (table == "observations") return study::added_row(study.observations, line);
    if (table == "model") return study::added_row(study.models, line);
    return &study;
  };
  const auto check = [&](study::StudyProblems& problems) { StudyCheck(study, problems).check(); };
  reading.warnings = study::read_study_text(text, file, study, {study_tables(), row, check});
  return reading;
}

StudyReading read_study(const std::filesystem::path& file) {
  return read_study_text(project::text_of_file(file, "study"), file);
}

}  // namespace talus::calibration
