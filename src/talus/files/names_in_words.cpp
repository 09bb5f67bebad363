#include "talus/files/names_in_words.hpp"

#include <fmt/format.h>

#include <string_view>

#include "talus/core/nearest.hpp"

namespace talus {

namespace {
constexpr std::size_t most_listed = 20;
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size() && i < most_listed; ++i) {
    out += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", names[i]);
  }
  if (names.size() > most_listed) out += fmt::format(" and {} more", names.size() - most_listed);
  return out;
}

std::string meant(const std::string& name, const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto near = nearest(name, known);
  return near ? fmt::format("Did you mean \"{}\"?", *near) : "";
}

}  // namespace talus
