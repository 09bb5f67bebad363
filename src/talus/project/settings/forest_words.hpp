#pragma once
// What forests are, of a material or over the ground, in the words of the reference.

#include "talus/project/settings/limits.hpp"

namespace talus::project::declared::forest_words {

constexpr const char* density_source =
    "the densities: RocFall; the drags: as quoted for RAMMS::ROCKFALL, see docs/laws.md";
constexpr const char* drag_meaning = "b, the drag force on a rock among the trees, divided by its velocity.";
constexpr const char* drag_source = "RocFall, after Leine et al. 2014 and Bartelt et al. 2016 (RAMMS::ROCKFALL)";
constexpr const char* height_meaning =
    "Effective height of the forest: it slows rocks whose centre is less than this above the ground.";
constexpr const char* height_source = "RocFall, after Leine et al. 2014";
inline Range drag_range() { return above_0_up_to(most_drag_kg_s, "trees cannot push"); }
inline Range height_range() { return above_0_up_to(most_height_m, "a forest has a height"); }

}  // namespace talus::project::declared::forest_words
