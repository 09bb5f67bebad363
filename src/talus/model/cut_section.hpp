#pragma once
// The ground along a line on plan as a section of its own.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/campaign/model.hpp"

namespace talus {

struct SectionVertex {
  double distance = 0;  // along the line, on plan [m]
  Vec3 place;           // on the ground, in the user's coordinates [m]
};

/// The section of a 3D terrain along a line through two or more corners on plan, in the user's coordinates: a vertex
/// where the ground bends, without those that lie within `tolerance` [m] of the line through the others (Douglas and
/// Peucker). Throws BadInput, for which `where` names the line: a terrain that is itself a section, a line without
/// length, parts of the line without ground, and more than a million bends.
[[nodiscard]] std::vector<SectionVertex> cut_section(const ModelSurface& surface, const LocalFrame& frame,
                                                     std::span<const std::array<double, 2>> line, double tolerance,
                                                     std::string_view where);

inline constexpr std::string_view section_header = "distance_m,z_m,x_m,y_m\n";
/// A table with these columns, which a project can name as its section.
[[nodiscard]] std::string section_table(std::span<const SectionVertex> section);

}  // namespace talus
