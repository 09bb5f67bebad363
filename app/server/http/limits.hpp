#pragma once
// How much one request may bring, and how long it may take.

#include <chrono>
#include <cstddef>

namespace talus::server {

struct Limits {
  std::size_t upload_bytes = 4ull << 30u;
  std::size_t json_bytes = 64u << 20u;                 // as large as a project file may be
  std::size_t head_bytes = 32u << 10u;                 // of a request's first line and all its headers together
  std::chrono::milliseconds head_time{5'000};          // from a head's first byte to its last
  std::chrono::milliseconds silent_time{60'000};       // between two requests of a connection
  std::size_t silent_connections = 256;                // whose next request is not there yet; the oldest make way
  std::chrono::milliseconds reading_time{5 * 60'000};  // of a model's files, until nobody waits for it any longer
};

}  // namespace talus::server
