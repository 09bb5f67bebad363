#pragma once
// Numbers, text and lists as bytes and back: for what is kept on disk or sent to another process. The same content
// gives the same bytes; numbers lie as this machine has them, which is little-endian.

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus {

static_assert(std::endian::native == std::endian::little, "saved bytes are little-endian");

/// A number of a fixed size: of a bool not every byte is one, of an enumeration not every number. The caller says what
/// those mean (flag(), or a number and a check).
template <class T>
concept PlainNumber = (std::integral<T> || std::floating_point<T>)&&!std::same_as<T, bool>;

/// Saved bytes that are not what they should be: cut short, changed, or of something else.
class BadBytes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends to bytes in memory, or hands them on piece by piece.
class ByteWriter {
 public:
  using Sink = std::function<void(std::string_view)>;

  ByteWriter() = default;
  /// Nothing is kept: the sink is given all bytes in their order, about a megabyte at a time, the last of them by
  /// flush().
  explicit ByteWriter(Sink sink) : sink_(std::move(sink)) {}

  template <PlainNumber T>
  void put(T value) {
    append(&value, sizeof value);
  }
  void flag(bool value) { put(static_cast<std::uint8_t>(value ? 1 : 0)); }
  /// Numbers of which the reader knows how many there are.
  template <PlainNumber T, std::size_t extent>
  void numbers(std::span<const T, extent> values) {
    append(values.data(), values.size_bytes());
  }
  /// Numbers, and before them how many.
  template <PlainNumber T>
  void list(const std::vector<T>& values) {
    count(values.size());
    numbers(std::span<const T>(values));
  }
  void text(std::string_view value) {
    count(value.size());
    append(value.data(), value.size());
  }
  /// How many things follow.
  void count(std::size_t things) { put(static_cast<std::uint64_t>(things)); }

  /// Hands the sink what it has not been given; without a sink nothing happens.
  void flush();
  /// All bytes, where there is no sink.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
    if (sink_ && bytes_.size() >= std::size_t{1} << 20) flush();
  }

  Sink sink_;
  std::string bytes_;  // with a sink, those that it has not been given
};

/// Reads what a ByteWriter wrote, and throws BadBytes where it cannot be that: it never reads past the end, and never
/// takes more memory than the bytes that are left could fill.
class ByteReader {
 public:
  /// The bytes must outlive the reader.
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  template <PlainNumber T>
  [[nodiscard]] T get() {
    T value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  [[nodiscard]] bool flag();
  template <PlainNumber T, std::size_t extent>
  void numbers(std::span<T, extent> values) {
    if (values.size_bytes() > 0) std::memcpy(values.data(), take(values.size_bytes()), values.size_bytes());
  }
  template <PlainNumber T>
  [[nodiscard]] std::vector<T> list() {
    std::vector<T> values(count(sizeof(T)));
    numbers(std::span<T>(values));
    return values;
  }
  [[nodiscard]] std::string text() { return std::string(bytes(count(1))); }
  /// So many bytes, as they lie.
  [[nodiscard]] std::string_view bytes(std::size_t size) { return {take(size), size}; }
  /// How many things follow, each of at least `least_size` bytes, above 0; refuses more than there can be.
  [[nodiscard]] std::size_t count(std::size_t least_size);

  [[nodiscard]] std::size_t left() const { return left_.size(); }
  /// Refuses bytes that are left over.
  void expect_end() const;

 private:
  [[nodiscard]] const char* take(std::size_t size);

  std::string_view left_;
};

/// For readers: throws BadBytes with this reason if what was read breaks a rule of its writer.
inline void expect_bytes(bool holds, const char* otherwise) {
  if (!holds) throw BadBytes(otherwise);
}

}  // namespace talus
