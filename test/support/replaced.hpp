#pragma once
// Texts with a part replaced.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace talus::testing_tools {

/// The text with the first occurrence of `part` replaced; a test failure if there is none.
[[nodiscard]] inline std::string replaced(std::string text, std::string_view part, std::string_view with) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << "not in the text: " << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), with);
}

}  // namespace talus::testing_tools
