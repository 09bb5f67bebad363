#pragma once
// How much one request may bring.

#include <cstddef>

namespace talus::server {

struct Limits {
  std::size_t upload_bytes = 4ull << 30u;
  std::size_t json_bytes = 64u << 20u;  // as large as a project file may be
};

}  // namespace talus::server
