#pragma once
// The same project with rocks of another model: point, sphere or block.

#include <string>
#include <string_view>
#include <vector>

#include "talus/project/project.hpp"

namespace talus::project {

/// The shape of blocks where the project has none: measured ones (docs/shapes.md), in a section a rectangle whose sides
/// are as their two shorter axes.
[[nodiscard]] std::string_view usual_block(bool is_2d);

/// The project with rocks of this model. As `rigid_body`, rocks without a shape get that of usual_block().
[[nodiscard]] Project with_rock_model(const Project& project, RockModel model);

/// The materials that have the default friction of the project's model, which nobody has chosen; by name.
[[nodiscard]] std::vector<std::string> materials_of_default_friction(const Project& project);

/// "rigid sphere"
[[nodiscard]] std::string_view name_of(RockModel model);

}  // namespace talus::project
