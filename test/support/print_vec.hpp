#pragma once
// Vectors in the messages of tests.

#include <ostream>

#include "talus/core/vec.hpp"

namespace talus {

template <std::size_t N>
std::ostream& operator<<(std::ostream& out, const Vec<N>& v) {
  out << '(' << v[0];
  for (std::size_t i = 1; i < N; ++i) out << ", " << v[i];
  return out << ')';
}

}  // namespace talus
