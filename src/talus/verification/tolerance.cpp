#include "talus/verification/tolerance.hpp"

#include <fmt/format.h>

namespace talus::verification {

std::string Tolerance::text() const {
  std::string text;
  const auto add = [&](std::string part) { text += (text.empty() ? "" : " or ") + part; };
  if (units > 0) add(fmt::format("{:g} unit{} of the last printed digit", units, units == 1 ? "" : "s"));
  if (relative > 0) add(fmt::format("{:g} %", relative * 100));
  if (absolute > 0) add(fmt::format("{:g}", absolute));
  if (of_scale > 0) add(fmt::format("{:g} % of the largest number of its kind", of_scale * 100));
  return text.empty() ? "equal" : text;
}

}  // namespace talus::verification
