#include "option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace talus::cli {

namespace {

struct Whole {
  std::int64_t number = 0;
  bool is_too_large = false;  // does not fit into 64 bits, positive or negative
};

std::optional<Whole> whole(std::string_view text) {
  Whole read;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read.number);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  read.is_too_large = error == std::errc::result_out_of_range;
  return read;
}

}  // namespace

CLI::Validator natural_number() {
  return {[](std::string& text) -> std::string {
            const auto read = whole(text);
            if (!read) return fmt::format("\"{}\" is not a whole number", text);
            if (text.starts_with('-')) return "expected 0 or more";
            constexpr auto most = std::numeric_limits<std::int64_t>::max();
            if (read->is_too_large) return fmt::format("{} is too large; expected at most {}", text, most);
            text = std::to_string(read->number);
            return "";
          },
          ""};
}

CLI::Validator number_of_rocks() {
  return {[](std::string& text) -> std::string {
            const auto read = whole(text);
            if (!read) return fmt::format("\"{}\" is not a whole number", text);
            if (read->is_too_large) return fmt::format("{} is not a number of rocks; expected 1 to 1e12", text);
            text = std::to_string(read->number);
            return "";
          },
          ""};
}

CLI::Validator memory_size() {
  return {[](std::string& text) -> std::string {
            constexpr std::pair<std::string_view, double> units[] = {{"MB", 1e6}, {"GB", 1e9}, {"TB", 1e12}};
            double number = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            const std::string_view behind(end, static_cast<std::size_t>(text.data() + text.size() - end));
            const auto unit = std::ranges::find(units, behind, &std::pair<std::string_view, double>::first);
            if (error != std::errc() || unit == std::end(units) || !std::isfinite(number))
              return fmt::format("\"{}\" is not a size; expected a number with MB, GB or TB, for example 4GB", text);
            const double bytes = number * unit->second;
            if (bytes < 1e6 || bytes > 1e15)
              return fmt::format("{} is not an amount of memory; expected 1MB to 1000TB", text);
            text = fmt::format("{:.0f}", bytes);
            return "";
          },
          ""};
}

CLI::Validator not_empty(std::string message) {
  return {[message = std::move(message)](const std::string& text) { return text.empty() ? message : ""; }, ""};
}

}  // namespace talus::cli
