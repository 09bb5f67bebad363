#pragma once
// The reference layers of a project: what they are, and whether they can be drawn.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus {

enum class LayerKind { raster, vector };

/// What a layer's file is, by its contents. Throws BadInput if it is no file, or neither.
[[nodiscard]] LayerKind kind_of_layer(const std::filesystem::path& file);

namespace project {

/// Calls `draw(file, warnings)` for a layer of the project. Its problems, and those of a file that is missing or leads
/// out of the project's folder, are thrown as BadInput or added to `warnings` as problems of the layer's row.
void with_layer(const Project& project, std::size_t layer, Problems& warnings,
                const std::function<void(const std::filesystem::path& file, Problems& warnings)>& draw);

/// Checks that every layer can be read and lies over the terrain. Throws BadInput with the problems of all of them.
/// Nothing is checked in 2D, where layers have no place.
void check_layers(const Project& project, const Model& model, Problems& warnings);

}  // namespace project

}  // namespace talus
