#pragma once
// The fixed parts of the report's page, put into the library when it is built (cmake/embed.cmake).

#include <string_view>

namespace talus::assets {

extern const std::string_view page;     // page.html, with places like {{title}}
extern const std::string_view style;    // web/src/figures/figures.css and style.css
extern const std::string_view script;   // the .js files beside this one, in the order of cmake/embed.cmake
extern const std::string_view figures;  // the figures shared with the workbench, and D3 (d3js.org; see NOTICE)

}  // namespace talus::assets
