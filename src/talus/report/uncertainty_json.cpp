#include "talus/report/uncertainty_json.hpp"

#include <fmt/format.h>

#include <string>

namespace talus {

nlohmann::ordered_json uncertainty_json(const Uncertainty& uncertainty) {
  using Json = nlohmann::ordered_json;
  const auto short_number = [](double value) { return std::stod(fmt::format("{:.6g}", value)); };
  const auto range = [&](const Estimate& e) {
    return Json{short_number(e.value), short_number(*e.low), short_number(*e.high)};
  };
  auto figures = Json::array();
  for (const FigureUncertainty& each : uncertainty.figures) {
    figures.push_back({{"line", each.line},
                       {"text", each.figure.text()},
                       {"unit", quantity_of(each.figure.of).unit},
                       {"ensembles", each.ensembles},
                       {"total", range(each.total)},
                       {"parameters", range(each.parameters)},
                       {"rocks", range(each.rocks)},
                       {"parameter_share", short_number(each.parameter_share)}});
  }
  return {
      {"ensembles", uncertainty.ensembles}, {"confidence", Uncertainty::confidence}, {"figures", std::move(figures)}};
}

}  // namespace talus
