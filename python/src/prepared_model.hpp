#pragma once
// A model that is built once, for many runs.

#include <memory>

#include "given_project.hpp"
#include "site.hpp"
#include "talus/model/build_terrain.hpp"

namespace talus::python {

class PreparedModel {
 public:
  /// Reads the terrain and places everything on it. Throws BadInput.
  explicit PreparedModel(std::shared_ptr<const GivenProject> given);

  [[nodiscard]] const std::shared_ptr<const Site>& site() const { return site_; }
  /// The site with other settings, on the same terrain. Values of materials, laws, capacities, sizes and velocities,
  /// and the seed, take next to no time. Throws BadInput; also on settings of the terrain and its ground. Can be called
  /// by several threads.
  [[nodiscard]] std::shared_ptr<const Site> site_with(const project::Overrides& overrides) const;

 private:
  std::shared_ptr<const GivenProject> given_;
  Problems build_warnings_;
  project::BuiltTerrain terrain_;
  std::shared_ptr<const Site> site_;
};

}  // namespace talus::python
