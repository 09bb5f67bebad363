#include "http/arrays.hpp"

#include <bit>
#include <cstring>
#include <vector>

namespace talus::server {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");

namespace {

void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 7) / 8 * 8, with); }

}  // namespace

template <class T>
void Arrays::add(std::string_view name, const char* type, std::span<const T> values) {
  header_["arrays"].push_back({{"name", name}, {"type", type}, {"count", values.size()}});
  bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  pad(bytes_, '\0');
}

template void Arrays::add(std::string_view, const char*, std::span<const float>);
template void Arrays::add(std::string_view, const char*, std::span<const double>);
template void Arrays::add(std::string_view, const char*, std::span<const std::uint8_t>);
template void Arrays::add(std::string_view, const char*, std::span<const std::uint16_t>);
template void Arrays::add(std::string_view, const char*, std::span<const std::uint32_t>);

void Arrays::add_smallest(std::string_view name, std::span<const std::uint32_t> values, std::size_t count) {
  if (count <= 1U << 8U) {
    add(name, std::span<const std::uint8_t>(std::vector<std::uint8_t>(values.begin(), values.end())));
  } else if (count <= 1U << 16U) {
    add(name, std::span<const std::uint16_t>(std::vector<std::uint16_t>(values.begin(), values.end())));
  } else {
    add(name, values);
  }
}

Answer Arrays::answer() const {
  const std::string header = header_.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string body = "TALA";
  const std::size_t padded = (8 + header.size() + 7) / 8 * 8 - 8;
  const auto length = static_cast<std::uint32_t>(padded);
  body.append(reinterpret_cast<const char*>(&length), sizeof length);
  body += header;
  pad(body, ' ');
  body += bytes_;
  return {.type = "application/x-talus-arrays", .body = std::move(body)};
}

}  // namespace talus::server
