#include "talus/report/report_histograms.hpp"

#include <optional>
#include <string>

#include "talus/statistics/histogram.hpp"

namespace talus::io {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t most_bins = 50;  // more would be lines, of two runs side by side

/// Of {"low": ..., "width": ..., "counts": [...]}.
std::optional<Histogram> histogram_of(const Json& json) {
  if (!json.is_object() || !json.contains("counts") || !json["counts"].is_array()) return std::nullopt;
  const Json& counts = json["counts"];
  const auto number = [&](const char* key) {
    return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0;
  };
  const auto edges = bins_from(number("low"), number("width"), counts.size());
  if (!edges) return std::nullopt;
  Histogram histogram(*edges);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (!counts[k].is_number_unsigned()) return std::nullopt;
    histogram.add_to(k, counts[k].get<std::uint64_t>());
  }
  return histogram;
}

void set(Json& json, const Histogram& histogram) {
  const BinEdges& edges = histogram.edges();
  json["low"] = edges.edge(0);
  json["width"] = BinEdges{1, edges.step_digit, edges.step_exponent, 1}.edge(0);
  json["counts"] = histogram.counts();
}

/// Of all quantities that both have.
void share_bins(Json& first, Json& second) {
  if (!first.is_object() || !second.is_object()) return;
  for (auto& [quantity, one] : first.items()) {
    if (!second.contains(quantity)) continue;
    Json& other = second[quantity];
    const auto a = histogram_of(one), b = histogram_of(other);
    if (!a || !b) continue;
    const BinEdges edges = common_bins(a->edges(), b->edges(), most_bins);
    set(one, a->regrouped(edges));
    set(other, b->regrouped(edges));
  }
}

}  // namespace

void give_common_bins(Json& first, Json& second) {
  if (!first.is_object() || !second.is_object()) return;
  if (first.contains("histograms") && second.contains("histograms"))
    share_bins(first["histograms"], second["histograms"]);
  if (!first.contains("barriers") || !second.contains("barriers")) return;
  for (Json& here : first["barriers"]) {
    for (Json& there : second["barriers"]) {
      const bool are_one = here.is_object() && there.is_object() && here.contains("histograms") &&
                           there.contains("histograms") && here.value("name", "") == there.value("name", "");
      if (are_one) share_bins(here["histograms"], there["histograms"]);
    }
  }
}

}  // namespace talus::io
