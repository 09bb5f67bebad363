#pragma once
// Answers of polygons (area_answer.hpp) as JSON; docs/ask-the-line.md describes the keys.

#include <nlohmann/json.hpp>

#include "talus/lines/area_answer.hpp"
#include "talus/lines/line_json.hpp"

namespace talus {

[[nodiscard]] nlohmann::ordered_json area_json(const Model& model, const AskedArea& area, const AreaAnswer& answer,
                                               const StoredSources& sources, const AnswerOptions& options);

}  // namespace talus
