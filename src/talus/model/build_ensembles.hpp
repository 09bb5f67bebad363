#pragma once
// Ensembles of rocks with different parameters, drawn from a file.

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Gives a built model the ensembles of `sampling.parameters`. A set of parameters is drawn for each ensemble by
/// systematic resampling, with one random number of the project's seed (G. Kitagawa, "Monte Carlo filter and smoother
/// for non-Gaussian nonlinear state space models", Journal of Computational and Graphical Statistics 5 (1996) 1-25): a
/// set with the share w of the weight is drawn for w K of the K ensembles, rounded down or up. Throws BadInput with
/// every problem of the file; doubts are added to `warnings`.
void add_ensembles(const Project& project, Model& model, Problems& warnings);

}  // namespace talus::project
