#include "talus/core/utf8.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(Utf8, IsNotChanged) {
  for (const std::string text : {"", "slope", "Böschung", "\xF0\x9F\xAA\xA8 rock", "\xED\x9F\xBF\xEE\x80\x80"}) {
    EXPECT_EQ(as_utf8(text), text);
  }
}

TEST(Utf8, OtherBytesAreReplacedOneByOne) {
  const std::string no = "\xEF\xBF\xBD";
  EXPECT_EQ(as_utf8("sl\xFFope"), "sl" + no + "ope");
  EXPECT_EQ(as_utf8("\xC3"), no) << "truncated";
  EXPECT_EQ(as_utf8("\xC3("), no + "(");
  EXPECT_EQ(as_utf8("\xC0\xAF"), no + no) << "overlong";
  EXPECT_EQ(as_utf8("\xE0\x80\xAF"), no + no + no);
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), no + no + no) << "half of a surrogate pair";
  EXPECT_EQ(as_utf8("\xF4\x90\x80\x80"), no + no + no + no) << "beyond U+10FFFF";
}

}  // namespace
}  // namespace talus
