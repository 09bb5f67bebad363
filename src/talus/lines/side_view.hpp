#pragma once
// Paths of a what-if as seen from the side: the vertical plane along the mean way of the rocks with the project's own
// values, from their mean release; in 2D the section itself.

#include <nlohmann/json.hpp>

#include "talus/lines/what_if.hpp"

namespace talus::what_if {

/// {"is_section", "ground": [[s, z], ...] or null for a gap, "sets": [{"model", "paths": [[[s, z], ...], ...],
/// "runout_m": [...]}, ...]}: the project's own values, then each rock model. s: along the plane [m], in 2D x; z:
/// elevation [m], in the user's coordinates. The runouts are those on plan of all rocks, ascending, at most 201 of even
/// ranks. Null if no paths are kept (RunOptions::pictured).
[[nodiscard]] nlohmann::ordered_json side_view(const WhatIf& what_if);

}  // namespace talus::what_if
