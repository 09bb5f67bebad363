#include "talus/core/utf8.hpp"

#include <gtest/gtest.h>

namespace talus::utf8_test {
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

TEST(Utf8, OtherTextIsLatin1) {
  EXPECT_EQ(from_utf8_or_latin1("Höhe"), "Höhe");
  EXPECT_EQ(from_utf8_or_latin1("H\xF6he"), "Höhe");
  EXPECT_EQ(from_utf8_or_latin1("m\xB3 \xFF"), "m³ ÿ");
}

TEST(Utf8, MessagesShowWhatPrints) {
  EXPECT_EQ(for_message("Höhe", 10), "Höhe");
  EXPECT_EQ(for_message("H\xF6he", 10), "Höhe");
  EXPECT_EQ(for_message("Höhenlinie", 4), "Höhe...") << "characters, not bytes";
  EXPECT_EQ(for_message("a\tb\x1B[31mc\x7F", 20), "a?b?[31mc?");
  EXPECT_EQ(for_message("a\xC2\x9B"
                        "b\xE2\x80\xAE"
                        "c",
                        20),
            "a?b?c")
      << "control characters beyond ASCII, marks of direction";
}

TEST(Utf8, LettersWithoutUmlautsAndAccents) {
  EXPECT_EQ(in_ascii("Höhe HÖHE Größe Élévation Ærø"), "Hoehe HOeHE Groesse Elevation Aero");
  EXPECT_EQ(in_ascii("H\xF6he"), "Hoehe") << "Latin-1";
  EXPECT_EQ(in_ascii("Ho\xCC\x88he"), "Hoehe") << "letter and umlaut apart, as on a Mac";
  EXPECT_EQ(in_ascii("m³ 高"), "m³ 高");
}

}  // namespace
}  // namespace talus::utf8_test
