#include "talus/lines/varied_models.hpp"

#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/project/parameter.hpp"

namespace talus::what_if {

namespace {

/// The project with the values that an ensemble of its model has drawn.
project::Project project_of_ensemble(const project::Project& project, const Model& model, std::size_t ensemble) {
  project::Project drawn = project;
  for (std::size_t k = 0; k < model.uncertain.size(); ++k) {
    Problems problems;
    const auto number = project::SettingNumber::find(project, model.uncertain[k], {}, problems);
    if (number) static_cast<void>(number->set(drawn, model.drawn_parameters[ensemble][k]));  // the model was built so
  }
  return drawn;
}

}  // namespace

std::vector<Model> varied_models(const project::Project& project, const Model& model,
                                 std::span<const Variation> variations, const std::string& material) {
  std::vector<Model> models;
  const auto add = [&]() -> Model& {
    Model& added = models.emplace_back(model.without_surface());
    added.surface = model.surface;
    return added;
  };
  add().ensembles = model.ensembles;
  for (const Variation& variation : variations) {
    Model& varied = add();
    project::set_properties(variation.project, varied);
    for (std::size_t ensemble = 0; ensemble < model.ensembles.size(); ++ensemble) {
      stop_point();
      const project::Project drawn = project_of_ensemble(project, model, ensemble);
      Model& own = varied.ensembles.emplace_back(model.ensembles[ensemble].without_surface());
      project::set_properties(applied(variation, drawn, material), own);
    }
  }
  return models;
}

}  // namespace talus::what_if
