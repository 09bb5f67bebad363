#include "prepared_model.hpp"

#include <algorithm>
#include <array>

#include "talus/model/model.hpp"
#include "talus/model/samples.hpp"
#include "talus/project/parameter.hpp"
#include "talus/project/setting_paths.hpp"
#include "talus/run/report_inputs.hpp"

namespace talus::python {

namespace {

Problems joined(const Problems& first, const Problems& second) {
  Problems all = first;
  all.append(second);
  return all;
}

std::string_view path_of(std::string_view setting) { return setting.substr(0, setting.find('=')); }

/// Refuses settings of which the terrain was read.
void check_terrain_stays(const std::vector<std::string>& settings) {
  constexpr std::array of_terrain{"terrain", "ground", "area", "forest"};
  Problems problems;
  for (const std::string& setting : settings) {
    const auto path = project::parts_of(path_of(setting));
    if (project::needs_no_terrain(path_of(setting)) || !path ||
        std::ranges::find(of_terrain, path->front()) == of_terrain.end())
      continue;
    problems.add({.where = std::string(path_of(setting)),
                  .what = "cannot be changed in a prepared model",
                  .why = "its terrain is read once",
                  .hint = "Change the project, and prepare another model"});
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

}  // namespace

PreparedModel::PreparedModel(std::shared_ptr<const GivenProject> given) : given_(std::move(given)) {
  const project::Project& project = given_->reading.project;
  terrain_ = project::read_terrain(project, build_warnings_);
  Model model = project::build_model(project, terrain_, build_warnings_);
  site_ = std::make_shared<const Site>(Site{
      project, std::move(model), joined(given_->reading.warnings, build_warnings_), project::report_inputs(project)});
}

std::shared_ptr<const Site> PreparedModel::site_with(const project::Overrides& overrides) const {
  if (overrides.settings.empty() && !overrides.rocks && !overrides.seed) return site_;
  check_terrain_stays(overrides.settings);
  project::Reading reading = project::read_project_text(given_->text, given_->file, given_->with(overrides));
  const bool is_of_numbers = std::ranges::all_of(
      overrides.settings, [](const std::string& setting) { return project::needs_no_terrain(path_of(setting)); });
  if (is_of_numbers && !overrides.rocks && site_->model.ensembles.empty()) {
    Site site{std::move(reading.project), site_->model, joined(reading.warnings, build_warnings_), site_->inputs};
    project::set_properties(project::read_samples(site.project, site.warnings), site.model);
    site.model.seed = site.project.sampling.seed;
    site.inputs.material_sources = project::material_sources(site.project);
    return std::make_shared<const Site>(std::move(site));
  }
  Problems warnings;
  Model model = project::build_model(reading.project, terrain_, warnings);
  ReportInputs inputs = project::report_inputs(reading.project);
  return std::make_shared<const Site>(
      Site{std::move(reading.project), std::move(model), joined(reading.warnings, warnings), std::move(inputs)});
}

}  // namespace talus::python
