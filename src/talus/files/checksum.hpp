#pragma once
// Checksums of bytes, to detect damage and to identify inputs.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace talus {

/// XXH3 with 128 bits (Y. Collet, xxHash 0.8): the same on every machine. Not cryptographic: inputs with the same
/// checksum can be constructed.
struct Digest {
  std::uint64_t high = 0, low = 0;
  friend bool operator==(const Digest&, const Digest&) = default;
};
/// As 32 hexadecimal digits.
[[nodiscard]] std::string text_of(const Digest& digest);

/// The checksum of bytes added in pieces; the result does not depend on how they are split.
class Checksum {
 public:
  Checksum();
  ~Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;
  void add(std::string_view bytes);
  [[nodiscard]] Digest digest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] Digest checksum_of(std::string_view bytes);

}  // namespace talus
