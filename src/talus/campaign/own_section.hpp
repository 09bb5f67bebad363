#pragma once
// The section of one rock, if vertices vary from rock to rock, and the barriers on it.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/sampling/draws.hpp"

namespace talus {

class OwnSection {
 public:
  /// Of a model with a varying section; `barriers` on the given one.
  OwnSection(const Model& model, std::vector<Barrier> barriers)
      : section_(*model.varying), profile_(section_.vertices), barriers_(std::move(barriers)) {}
  void move_for(const Model& model, std::uint64_t rock) {
    const Draws draws({model.seed, model.sampling, 0, model.rocks()}, rock);
    vertices_.clear();
    for (std::uint32_t k = 0; k < section_.vertices.size(); ++k) {
      const auto u = draws.pair(Stream::slope_vertex, k);
      const auto& shift = section_.shifts[k];
      vertices_.push_back(section_.vertices[k] + Vec2(shift[0].draw(u[0]), shift[1].draw(u[1])));
    }
    profile_.move_vertices(vertices_);
    for (Barrier& barrier : barriers_) {
      if (barrier.panels().empty()) continue;
      if (const auto z = profile_.elevation(barrier.panels().front().foot.x())) barrier.move_foot_to(*z);
    }
  }
  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] std::span<const Barrier> barriers() const { return barriers_; }  // unchanged on plan

 private:
  const VaryingSection& section_;
  Profile profile_;
  std::vector<Barrier> barriers_;
  std::vector<Vec2> vertices_;
};

}  // namespace talus
