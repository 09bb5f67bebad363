#include "talus/report/html_page.hpp"

#include <map>

#include "talus/report/page/assets.hpp"

namespace talus {

namespace {

std::string escaped(std::string_view text) {
  static const std::map<char, std::string_view> entities{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string out;
  for (const char c : text) {
    if (const auto found = entities.find(c); found != entities.end()) {
      out += found->second;
    } else {
      out += c;
    }
  }
  return out;
}

// JSON for a script element: no name in it can end the element or open a comment.
std::string json_for_script(const nlohmann::ordered_json& value) {
  std::string out;
  for (const char c : value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

// Fills the template's placeholders in one pass, so that inserted text is never taken for a placeholder.
std::string filled(std::string_view page, const std::map<std::string_view, std::string_view>& values) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t open = page.find("{{", at);
    if (open == std::string_view::npos) return out.append(page.substr(at));
    const std::size_t close = page.find("}}", open);
    out.append(page.substr(at, open - at)).append(values.at(page.substr(open + 2, close - open - 2)));
    at = close + 2;
  }
}

}  // namespace

std::string html_page(std::string_view title, const nlohmann::ordered_json& data, std::string_view script) {
  const std::string name = escaped(title), json = json_for_script(data);
  return filled(assets::page, {{"title", name}, {"style", assets::style}, {"data", json}, {"script", script}});
}

}  // namespace talus
