#include "talus/core/bytes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace talus::bytes_test {
namespace {

TEST(Bytes, AreReadAsTheyWereWritten) {
  ByteWriter out;
  out.put(std::int8_t{-3});
  out.put(std::numeric_limits<std::uint64_t>::max());
  out.put(-0.0);
  out.put(std::nextafter(1.0, 2.0));
  out.put(1.5f);
  out.flag(true);
  out.flag(false);
  out.text("Blöcke, \"große\"\0und kleine");
  out.text("");
  out.list(std::vector<std::uint16_t>{1, 2, 65535});
  out.list(std::vector<double>{});
  const std::array<std::int32_t, 2> pair{7, -8};
  out.numbers(std::span(pair));

  ByteReader in(out.bytes());
  EXPECT_EQ(in.get<std::int8_t>(), -3);
  EXPECT_EQ(in.get<std::uint64_t>(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_TRUE(std::signbit(in.get<double>()));
  EXPECT_EQ(in.get<double>(), std::nextafter(1.0, 2.0));
  EXPECT_EQ(in.get<float>(), 1.5f);
  EXPECT_TRUE(in.flag());
  EXPECT_FALSE(in.flag());
  EXPECT_EQ(in.text(), "Blöcke, \"große\"\0und kleine");
  EXPECT_EQ(in.text(), "");
  EXPECT_EQ(in.list<std::uint16_t>(), (std::vector<std::uint16_t>{1, 2, 65535}));
  EXPECT_TRUE(in.list<double>().empty());
  std::array<std::int32_t, 2> read{};
  in.numbers(std::span(read));
  EXPECT_EQ(read, pair);
  EXPECT_EQ(in.left(), 0U);
  in.expect_end();
}

TEST(Bytes, AreLittleEndian) {
  ByteWriter out;
  out.put(std::uint32_t{0x01020304});
  EXPECT_EQ(out.bytes(), "\x04\x03\x02\x01");
}

TEST(Bytes, WrittenToASinkEqualThoseInMemory) {
  ByteWriter memory;
  std::string sunk;
  std::size_t pieces = 0;
  ByteWriter streaming([&](std::string_view piece) {
    sunk += piece;
    ++pieces;
  });
  for (ByteWriter* out : {&memory, &streaming}) {
    for (std::uint64_t k = 0; k < 500'000; ++k) out->put(k);
    out->text("end");
    out->flush();
  }
  EXPECT_EQ(sunk, memory.bytes());
  EXPECT_GE(pieces, 3U);  // 4 MB are not buffered until the end
  EXPECT_TRUE(streaming.bytes().empty());
}

std::string why(const std::string& bytes, const std::function<void(ByteReader&)>& read) {
  ByteReader in(bytes);
  try {
    read(in);
  } catch (const BadBytes& bad) {
    return bad.what();
  }
  return "nothing was refused";
}

TEST(ByteReader, RefusesTruncatedData) {
  EXPECT_EQ(why("abc", [](ByteReader& in) { (void)in.get<std::uint32_t>(); }), "the data end too early");
  EXPECT_EQ(why("", [](ByteReader& in) { (void)in.flag(); }), "the data end too early");
  EXPECT_EQ(why("abc", [](ByteReader& in) { (void)in.bytes(4); }), "the data end too early");
  EXPECT_EQ(why("abc", [](ByteReader& in) { (void)in.bytes(2), in.expect_end(); }),
            "there are unexpected data at the end");
  EXPECT_EQ(why("\x02", [](ByteReader& in) { (void)in.flag(); }), "a flag is neither 0 nor 1");
}

// A length of 2^64 - 1, or one whose product with the size overflows, must neither be read nor allocated.
TEST(ByteReader, RefusesImpossibleLengths) {
  for (const std::uint64_t length : {~std::uint64_t{0}, std::uint64_t{1} << 61, (std::uint64_t{1} << 61) + 1,
                                     std::uint64_t{1} << 40, std::uint64_t{4}}) {
    ByteWriter out;
    out.put(length);
    out.put(1.0);
    out.put(2.0);
    out.put(3.0);
    const std::string bytes = out.bytes();
    EXPECT_EQ(why(bytes, [](ByteReader& in) { (void)in.list<double>(); }), "a list is longer than the data") << length;
    if (length > 24) {
      EXPECT_EQ(why(bytes, [](ByteReader& in) { (void)in.text(); }), "a list is longer than the data") << length;
    }
  }
}

}  // namespace
}  // namespace talus::bytes_test
