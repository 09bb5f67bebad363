#include "talus/meshing/findings.hpp"

#include <fmt/format.h>

namespace talus {

void Findings::add(const Vec3& where) {
  if (++count <= most_examples) examples.push_back(where);
}

std::string Findings::places() const {
  std::string out;
  for (const Vec3& at : examples) {
    out += fmt::format("{} ({:.3f}, {:.3f}, {:.3f})", out.empty() ? "" : ",", at.x(), at.y(), at.z());
  }
  if (out.empty()) return out;
  return (count > examples.size() ? ", for example at" : ", at") + out;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace talus
