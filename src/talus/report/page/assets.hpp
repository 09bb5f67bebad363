#pragma once
// The fixed parts of the report's page, embedded into the library at build time (cmake/embed.cmake).

#include <string_view>

namespace talus::assets {

extern const std::string_view page;    // page.html, with placeholders such as {{title}}
extern const std::string_view style;   // web/src/figures/figures.css and style.css
extern const std::string_view script;  // the .js files of this folder, in the order of cmake/embed.cmake, and
                                       // conditions and defaults of the declared settings
extern const std::string_view sensitivity_script;  // of the report of a sensitivity study
extern const std::string_view models_script;       // of the comparison of rock models
extern const std::string_view figures;  // the figures shared with the workbench, and D3 (d3js.org; see NOTICE)

}  // namespace talus::assets
