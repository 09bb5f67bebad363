#include "talus/files/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <new>

#include "talus/core/stop.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus {

namespace {

class Sha256 {
 public:
  Sha256() : state_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!state_ || EVP_DigestInit_ex(state_.get(), EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
  }
  void add(std::string_view bytes) { EVP_DigestUpdate(state_.get(), bytes.data(), bytes.size()); }
  [[nodiscard]] std::string digest() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int length = 0;
    EVP_DigestFinal_ex(state_.get(), bytes.data(), &length);
    std::string text;
    for (unsigned int k = 0; k < length; ++k) text += fmt::format("{:02x}", bytes[k]);
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> state_;
};

}  // namespace

std::string sha256_of(std::string_view bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.digest();
}

std::optional<std::string> sha256_of_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error) || not_an_ordinary_file(file)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  Sha256 sum;
  std::string piece(std::size_t{1} << 20, '\0');
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
    stop_point();
    sum.add(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  return in.eof() ? std::optional(sum.digest()) : std::nullopt;
}

}  // namespace talus
