#pragma once
// The fixed parts of the report's page, embedded into the library at build time (cmake/embed.cmake).

#include <string_view>

namespace talus::assets {

extern const std::string_view page;   // page.html, with placeholders such as {{title}}
extern const std::string_view style;  // web/src/figures/figures.css and style.css
// Scripts of the pages, bundled from web/src/report with the figures and D3 (d3js.org; see NOTICE):
extern const std::string_view report_script;       // of a run's report
extern const std::string_view sensitivity_script;  // of the report of a sensitivity study
extern const std::string_view models_script;       // of the comparison of rock models
extern const std::string_view calibration_script;  // of a calibration
extern const std::string_view validation_script;   // of a field experiment

}  // namespace talus::assets
