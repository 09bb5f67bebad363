#include "talus/calibration/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "talus/core/utf8.hpp"
#include "talus/project/document.hpp"
#include "talus/project/read_table.hpp"

namespace talus::validation {

namespace {

using calibration::Study;
using project::Row;

Row added_row(Experiment& experiment, std::string_view table, int line) {
  const auto with_line = [line](auto& list) {
    list.emplace_back().line = line;
    return Row(&list.back());
  };
  if (table == "model") return with_line(experiment.models);
  if (table == "published") return with_line(experiment.published);
  return &experiment;
}

/// What a study must be so that its sites can be predicted from each other.
void check_study(const ExperimentModel& model, const Study& study, Problems& problems) {
  const auto refuse = [&](int line, std::string what, std::string why, std::string hint) {
    problems.add({.file = study.file.string(),
                  .line = line,
                  .where = fmt::format("model \"{}\"", model.name),
                  .what = std::move(what),
                  .why = std::move(why),
                  .hint = std::move(hint)});
  };
  if (study.sites.size() < 2) {
    refuse(0, "the study has one site", "each site is predicted from the others",
           "Give each half of the runs its own [[site]], with its releases and its [[observations]]");
  }
  for (const auto& parameter : study.parameters) {
    if (parameter.each_site || parameter.sites.size() == 1) {
      refuse(parameter.line, fmt::format("parameter \"{}\" belongs to one site", parameter.path),
             "its value cannot be predicted from the other sites",
             parameter.each_site ? "Leave each_site out" : "Leave sites out");
    }
  }
  if (!study.models.empty()) {
    refuse(study.models.front().line, "the study has [[model]]", "an experiment compares studies",
           "Write a study for each, and name them in experiment.toml");
  }
  for (const auto& site : study.sites) {
    const auto has_stops = [&](const calibration::StudyObservations& each) {
      return each.site == site.name && !each.stops.empty();
    };
    if (std::ranges::count_if(study.observations, has_stops) == 1) continue;
    refuse(site.line, fmt::format("site \"{}\" does not have one file of stops", site.name),
           "predicted stops are compared with observed ones, run by run", "Give it one [[observations]] with stops");
  }
}

}  // namespace

Experiment read_experiment(const std::filesystem::path& folder, Problems& warnings) {
  Experiment experiment;
  experiment.file = folder / experiment_file;
  experiment.name = as_utf8(std::filesystem::absolute(folder).lexically_normal().filename().string());
  if (experiment.name.empty()) {
    experiment.name = as_utf8(std::filesystem::absolute(folder).lexically_normal().parent_path().filename().string());
  }
  std::error_code none;
  if (!std::filesystem::exists(experiment.file, none)) {
    throw BadInput(Problem{.file = folder.string(),
                           .what = fmt::format("there is no {} in this folder", experiment_file),
                           .why = "an experiment is a folder with its declaration, studies, projects and data",
                           .hint = "docs/validation.md lists its files"});
  }
  Problems problems;
  const project::Document document(project::text_of_file(experiment.file), experiment.file.string());
  project::ValueReader reader(document, problems, experiment_tables());
  for (const project::Table& table : experiment_tables()) {
    project::read_table(
        table, document, reader, [&](int line) { return added_row(experiment, table.key, line); }, "an experiment",
        problems);
  }
  for (const ExperimentModel& model : experiment.models) {
    if (model.study.empty()) continue;
    const auto about = [&](std::string what, std::string why, std::string hint) {
      problems.add({.file = document.file(),
                    .line = model.line,
                    .where = fmt::format("model \"{}\"", model.name),
                    .what = std::move(what),
                    .why = std::move(why),
                    .hint = std::move(hint)});
    };
    const auto same = [&](const ExperimentModel& other) { return &other < &model && other.name == model.name; };
    if (std::ranges::any_of(experiment.models, same)) {
      about(fmt::format("name \"{}\" is given twice", model.name), "names must be unique", "");
    }
    if (model.study.has_parent_path()) {
      about(fmt::format("study is \"{}\"", model.study.string()), "an experiment is one folder",
            "Put the study beside experiment.toml and give its name alone");
      continue;
    }
    try {
      calibration::StudyReading reading = calibration::read_study(folder / model.study);
      warnings.append(reading.warnings);
      check_study(model, reading.study, problems);
      experiment.studies.push_back(std::move(reading.study));
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  problems = problems.in_order_of(document.file());
  if (problems.has_errors()) throw BadInput(std::move(problems));
  warnings.append(problems);
  return experiment;
}

}  // namespace talus::validation
