#pragma once
// A page with its data, style, figures and script in one file, which opens from disk without a network.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace talus {

/// The page of report/page/page.html with this title and data, drawn by `script`, a bundle of web/src/report.
[[nodiscard]] std::string html_page(std::string_view title, const nlohmann::ordered_json& data,
                                    std::string_view script);

}  // namespace talus
