#pragma once
// Lines and polygons that a user gives: as text, in a table or in a GIS file.

#include <string>
#include <string_view>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/lines/asked_line.hpp"

namespace talus {

enum class PlanShape { line, polygon };

/// The places of `given`: "x,y x,y ..." (in 2D also an x alone), or the name of a file: a table (.csv, .txt, .tsv) with
/// the columns x_m and y_m, or a GIS file with one line or polygon, which is transformed to the coordinate system of
/// the model. Throws BadInput with all problems; `where` names the option.
[[nodiscard]] std::vector<PlanPlace> places_given(std::string_view given, PlanShape shape, const Model& model,
                                                  std::string_view where, Problems& warnings);

}  // namespace talus
