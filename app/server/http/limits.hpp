#pragma once
// Limits of the size and the duration of requests.

#include <chrono>
#include <cstddef>

namespace talus::server {

struct Limits {
  std::size_t upload_bytes = 4ull << 30u;
  std::size_t json_bytes = 64u << 20u;                 // the largest project file
  std::size_t head_bytes = 32u << 10u;                 // a request's first line and headers
  std::chrono::milliseconds head_time{5'000};          // from a head's first byte to its last
  std::chrono::milliseconds idle_time{60'000};         // between two requests of a connection
  std::size_t idle_connections = 256;                  // without a complete head; beyond that the oldest are closed
  std::chrono::milliseconds reading_time{5 * 60'000};  // a model with its files
};

}  // namespace talus::server
