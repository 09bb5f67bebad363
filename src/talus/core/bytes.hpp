#pragma once
// Writes numbers, text and lists as bytes, and reads them back: for data on disk or sent to another process. The same
// content gives the same bytes; numbers are in this machine's order, little-endian.

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

/// A number of a fixed size for which every bit pattern is valid. That excludes bool (use flag()) and enumerations
/// (write a number, and check it).
template <class T>
concept PlainNumber = (std::integral<T> || std::floating_point<T>)&&!std::same_as<T, bool>;

/// Saved bytes that are cut short, changed, or of something else.
class BadBytes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends to bytes in memory, or passes them on piece by piece.
class ByteWriter {
 public:
  using Sink = std::function<void(std::string_view)>;

  ByteWriter() = default;
  /// Passes all bytes to the sink in order, about a megabyte at a time, the last of them in flush().
  explicit ByteWriter(Sink sink) : sink_(std::move(sink)) {}

  template <PlainNumber T>
  void put(T value) {
    append(&value, sizeof value);
  }
  void flag(bool value) { put(static_cast<std::uint8_t>(value ? 1 : 0)); }
  /// Numbers without their count, which the reader must know.
  template <PlainNumber T, std::size_t extent>
  void numbers(std::span<const T, extent> values) {
    append(values.data(), values.size_bytes());
  }
  /// Numbers, preceded by their count.
  template <PlainNumber T>
  void list(const std::vector<T>& values) {
    count(values.size());
    numbers(std::span<const T>(values));
  }
  void text(std::string_view value) {
    count(value.size());
    append(value.data(), value.size());
  }
  /// The number of items that follow.
  void count(std::size_t items) { put(static_cast<std::uint64_t>(items)); }

  /// Passes the remaining bytes to the sink, if there is one.
  void flush();
  /// All bytes; only without a sink.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
    if (sink_ && bytes_.size() >= std::size_t{1} << 20) flush();
  }

  Sink sink_;
  std::string bytes_;  // with a sink, those not yet passed on
};

/// Reads what a ByteWriter has written, and throws BadBytes if it cannot be that. It never reads past the end, and
/// never allocates more memory than the remaining bytes could fill.
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
  /// `size` bytes, as they are.
  [[nodiscard]] std::string_view bytes(std::size_t size) { return {take(size), size}; }
  /// The number of items that follow, each of at least `least_size` > 0 bytes; refuses more than can follow.
  [[nodiscard]] std::size_t count(std::size_t least_size);

  [[nodiscard]] std::size_t left() const { return left_.size(); }
  /// Refuses remaining bytes.
  void expect_end() const;

 private:
  [[nodiscard]] const char* take(std::size_t size);

  std::string_view left_;
};

/// For readers: throws BadBytes with this message unless the condition is true.
inline void expect_bytes(bool condition, const char* message) {
  if (!condition) throw BadBytes(message);
}

}  // namespace talus
