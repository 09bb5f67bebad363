#pragma once
// Answers of lines (line_answer.hpp) as JSON, for the server and `talus line`; docs/ask-the-line.md describes the keys.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/lines/line_answer.hpp"
#include "talus/lines/release_spots.hpp"

namespace talus {

struct KitSize {
  double height = 0, maximum_energy = 0;  // nominal [m], MEL [J]
};

struct AnswerOptions {
  std::optional<KitSize> kit;  // to judge
  double precision = 0.1;      // wanted: intervals reach no further than this share of the value to either side
  bool wants_sources = true;
};

/// The whole answer of one line, but for what the server adds. `sources`: where the stored rocks come from.
[[nodiscard]] nlohmann::ordered_json line_json(const Model& model, const AskedLine& line, const LineAnswer& answer,
                                               const StoredSources& sources, const AnswerOptions& options);
/// The line and the figures of the whole of it, for one of many lines.
[[nodiscard]] nlohmann::ordered_json short_line_json(const Model& model, const AskedLine& line,
                                                     const LineAnswer& answer);

/// How many rocks would make the figures as precise as wanted, and a sentence that says so.
[[nodiscard]] nlohmann::ordered_json enough_json(const LineAnswer& answer, double precision);
/// Rocks per place of release: the stored ones, those that cross and those that a kit does not stop.
[[nodiscard]] nlohmann::ordered_json sources_json(const StoredSources& sources, const std::vector<std::uint64_t>& rocks,
                                                  const std::optional<std::vector<std::uint64_t>>& clearing,
                                                  double confidence);
/// Places in the user's coordinates.
[[nodiscard]] nlohmann::ordered_json places_json(const Model& model, const std::vector<Vec3>& places);
[[nodiscard]] nlohmann::ordered_json maxima_json(const std::optional<CrossingMaxima>& maxima);

/// A share of rocks in percent, with one decimal; halves are rounded up: 1,905 of 2,000 are 95.3 %, as people and the
/// workbench have it.
[[nodiscard]] double rounded_percents(double share);
/// A number with three digits, or all before the point, as a card shows it: 0.42, 3.41, 18.2, 1,243.
[[nodiscard]] std::string three_digits(double value);
/// "class 2: 279 kJ, 5.57 m"; empty without a demand.
[[nodiscard]] std::string demand_text(const std::optional<KitDemand>& demand);

}  // namespace talus
