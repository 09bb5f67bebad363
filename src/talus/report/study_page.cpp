#include "talus/report/study_page.hpp"

#include <utility>

#include "talus/report/html_page.hpp"
#include "talus/report/page/assets.hpp"

namespace talus {

std::string study_page(std::string_view name, const nlohmann::ordered_json& summary) {
  return html_page(name, summary, assets::sensitivity_script);
}

std::string models_page(std::string_view name, const nlohmann::ordered_json& comparison) {
  return html_page(name, comparison, assets::models_script);
}

std::string calibration_page(std::string_view name, nlohmann::ordered_json summary, nlohmann::ordered_json sets) {
  summary["posterior_sets"] = std::move(sets);
  return html_page(name, summary, assets::calibration_script);
}

std::string validation_page(std::string_view title, const nlohmann::ordered_json& experiment) {
  return html_page(title, experiment, assets::validation_script);
}

}  // namespace talus
