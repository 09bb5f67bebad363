#pragma once
// The models of a project's own values and of its variations, on one surface.

#include <span>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/lines/what_if_factors.hpp"
#include "talus/project/project.hpp"

namespace talus::what_if {

/// The model as it is, then one for each variation, all on its surface. Ensembles of uncertain parameters are varied by
/// the same share, each from its own values.
[[nodiscard]] std::vector<Model> varied_models(const project::Project& project, const Model& model,
                                               std::span<const Variation> variations, const std::string& material);

}  // namespace talus::what_if
