#pragma once
// Rocks that pass beyond the ends of a line that is asked: they do not cross it, but would if it went on.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/lines/line_answer.hpp"

namespace talus {

/// Of the rocks that do not cross the line, those that cross its straight continuation beyond its first and beyond its
/// last point; each is as long as the line, and ends with the terrain. Nullopt: the line has no ends, in a section or
/// around a place.
[[nodiscard]] std::optional<std::array<std::uint64_t, 2>> rocks_beyond_ends(const Model& model,
                                                                            const project::DesignBasis& basis,
                                                                            const RockPaths& paths,
                                                                            const AskedLine& line,
                                                                            const LineAnswer& answer);

/// Warns if they would change the share that crosses by more than a hundredth of it. `where`: the line.
void doubt_ends(const std::string& where, const std::array<std::uint64_t, 2>& beyond, const LineAnswer& answer,
                Problems& warnings);

}  // namespace talus
