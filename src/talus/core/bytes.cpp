#include "talus/core/bytes.hpp"

namespace talus {

void ByteWriter::flush() {
  if (!sink_) return;
  if (!bytes_.empty()) sink_(bytes_);
  bytes_.clear();
}

const char* ByteReader::take(std::size_t size) {
  expect_bytes(size <= left_.size(), "the data end too early");
  const char* const begin = left_.data();
  left_.remove_prefix(size);
  return begin;
}

bool ByteReader::flag() {
  const auto value = get<std::uint8_t>();
  expect_bytes(value <= 1, "a flag is neither 0 nor 1");
  return value == 1;
}

std::size_t ByteReader::count(std::size_t least_size) {
  const auto items = get<std::uint64_t>();
  expect_bytes(items <= left_.size() / least_size, "a list is longer than the data");
  return static_cast<std::size_t>(items);
}

void ByteReader::expect_end() const { expect_bytes(left_.empty(), "there are unexpected data at the end"); }

}  // namespace talus
