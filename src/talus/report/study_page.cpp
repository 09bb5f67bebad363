#include "talus/report/study_page.hpp"

#include "talus/report/html_page.hpp"
#include "talus/report/page/assets.hpp"

namespace talus {

std::string study_page(std::string_view name, const nlohmann::ordered_json& summary) {
  return html_page(name, summary, assets::sensitivity_script);
}

std::string models_page(std::string_view name, const nlohmann::ordered_json& comparison) {
  return html_page(name, comparison, assets::models_script);
}

}  // namespace talus
