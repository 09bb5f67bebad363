#include "option_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace talus::cli {

namespace {

struct Whole {
  std::int64_t number = 0;
  bool is_too_large = false;  // for 64 bits, on either side of 0
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
            if (!read) return fmt::format("\"{}\" is no whole number", text);
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
            if (!read) return fmt::format("\"{}\" is no whole number", text);
            if (read->is_too_large) return fmt::format("{} is no number of rocks; expected 1 to 1e12", text);
            text = std::to_string(read->number);
            return "";
          },
          ""};
}

CLI::Validator not_empty(std::string complaint) {
  return {[complaint = std::move(complaint)](const std::string& text) { return text.empty() ? complaint : ""; }, ""};
}

}  // namespace talus::cli
