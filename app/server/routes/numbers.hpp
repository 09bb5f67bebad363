#pragma once
// Lists of numbers in the body of a request.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "http/router.hpp"

namespace talus::server {

/// A list of `least` to `most` lists of `count` finite numbers each. Refused (400) otherwise, or if a number is so
/// large that its square might overflow.
template <std::size_t count>
[[nodiscard]] std::vector<std::array<double, count>> number_lists(const Json& list, const std::string& name,
                                                                  std::size_t least, std::size_t most) {
  constexpr double largest = 1e12;
  if (!list.is_array() || list.size() < least || list.size() > most)
    throw Refusal(400, name, "is not valid", fmt::format("expected a list of {} to {} places", least, most));
  std::vector<std::array<double, count>> numbers(list.size());
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Json& entry = list[k];
    bool is_good = entry.is_array() && entry.size() == count;
    for (std::size_t i = 0; is_good && i < count; ++i) {
      is_good = entry[i].is_number() && std::abs(entry[i].template get<double>()) <= largest;
      if (is_good) numbers[k][i] = entry[i].template get<double>();
    }
    if (!is_good)
      throw Refusal(400, fmt::format("{}[{}]", name, k), "is not valid", fmt::format("expected {} numbers", count));
  }
  return numbers;
}

/// As above, for a key of the body.
template <std::size_t count>
[[nodiscard]] std::vector<std::array<double, count>> number_lists(const Call& call, const char* key, std::size_t least,
                                                                  std::size_t most) {
  const auto found = call.body.find(key);
  if (found == call.body.end()) throw Refusal(400, key, "is missing");
  return number_lists<count>(*found, key, least, most);
}

}  // namespace talus::server
