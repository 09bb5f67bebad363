#include "talus/files/checksum.hpp"

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace talus {

namespace {

Digest digest_of(XXH128_hash_t hash) { return {hash.high64, hash.low64}; }

}  // namespace

std::string text_of(const Digest& digest) { return fmt::format("{:016x}{:016x}", digest.high, digest.low); }

struct Checksum::State {
  XXH3_state_t hash;
};

Checksum::Checksum() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->hash); }
Checksum::~Checksum() = default;
void Checksum::add(std::string_view bytes) { XXH3_128bits_update(&state_->hash, bytes.data(), bytes.size()); }
Digest Checksum::digest() const { return digest_of(XXH3_128bits_digest(&state_->hash)); }

Digest checksum_of(std::string_view bytes) { return digest_of(XXH3_128bits(bytes.data(), bytes.size())); }

}  // namespace talus
