#include "talus/sliding/glide.hpp"

#include "talus/core/check.hpp"

// Compiled twice, for processors with AVX2 and for all others; the same operations, so the same bits. (Not with a
// sanitizer: the version is selected before the sanitizer is initialized.)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define TALUS_WIDE_LANES __attribute__((target_clones("avx2", "default")))
#else
#define TALUS_WIDE_LANES
#endif

namespace talus {

GlideLanes::GlideLanes(const GlideLaws& laws) : laws_(laws) {
  // Empty lanes get numbers that are harmless in every operation, and that take no step.
  for (Lanes* each :
       {&x_, &y_, &vy_, &speed_, &time_, &timestep_, &gain_, &braking_, &kept_, &squared_way_, &way_to_bump_})
    each->fill(0);
  vx_.fill(1);
  for (std::size_t k = 0; k < 3; ++k) {
    for (Lanes* each : {&distance_[k], &down_[k], &aside_[k]}) each->fill(0);
  }
}

void GlideLanes::add(Glide& glide, std::vector<GlideStep>* trace, std::size_t name) {
  TALUS_PROMISE(!is_full(), "there is a free lane");
  const auto lane = static_cast<std::size_t>(std::countr_one(occupied_));
  occupied_ |= LaneSet{1} << lane;
  if (trace != nullptr) traced_ |= LaneSet{1} << lane;
  glides_[lane] = &glide;
  traces_[lane] = trace;
  names_[lane] = name;
  x_[lane] = glide.x;
  y_[lane] = glide.y;
  vx_[lane] = glide.vx;
  vy_[lane] = glide.vy;
  speed_[lane] = glide.speed;
  time_[lane] = glide.time;
  timestep_[lane] = glide.timestep;
  gain_[lane] = glide.gain;
  braking_[lane] = glide.braking;
  kept_[lane] = glide.kept;
  squared_way_[lane] = glide.squared_way;
  way_to_bump_[lane] = glide.way_to_bump;
  for (std::size_t k = 0; k < 3; ++k) {
    distance_[k][lane] = glide.sides[k].distance;
    down_[k][lane] = glide.sides[k].down;
    aside_[k][lane] = glide.sides[k].aside;
  }
}

std::size_t GlideLanes::take(std::size_t lane) {
  Glide& glide = *glides_[lane];
  glide.x = x_[lane];
  glide.y = y_[lane];
  glide.vx = vx_[lane];
  glide.vy = vy_[lane];
  glide.speed = speed_[lane];
  glide.time = time_[lane];
  glide.way_to_bump = way_to_bump_[lane];
  occupied_ &= ~(LaneSet{1} << lane);
  traced_ &= occupied_;
  return names_[lane];
}

namespace {

/// `taken` if all bits of the mask are set, `left` if none is. With bit operations: the compiler would turn a
/// conditional expression into a masked store, which takes longer than the rest of a step because the next load waits
/// for it.
inline double chosen(std::uint64_t mask, double taken, double left) {
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(taken) & mask) |
                               (std::bit_cast<std::uint64_t>(left) & ~mask));
}

}  // namespace

// One loop without branches, which the compiler vectorizes. Returns the lanes whose step was taken.
TALUS_WIDE_LANES auto GlideLanes::step_all() -> LaneSet {
  constexpr std::array<LaneSet, width> bits = [] {
    std::array<LaneSet, width> each{};
    for (std::size_t lane = 0; lane < width; ++lane) each[lane] = LaneSet{1} << lane;
    return each;
  }();
  LaneSet staying = 0;
  const GlideLaws laws = laws_;
  for (std::size_t k = 0; k < width; ++k) {
    const Glide glide{{x_[k], y_[k], vx_[k], vy_[k], speed_[k], time_[k], way_to_bump_[k]},
                      timestep_[k],
                      gain_[k],
                      braking_[k],
                      kept_[k],
                      squared_way_[k],
                      {{{distance_[0][k], down_[0][k], aside_[0][k]},
                        {distance_[1][k], down_[1][k], aside_[1][k]},
                        {distance_[2][k], down_[2][k], aside_[2][k]}}}};
    const auto [then, stays] = after_step(laws, glide);
    const std::uint64_t mask = stays ? ~std::uint64_t{0} : 0;
    x_[k] = chosen(mask, then.x, x_[k]);
    y_[k] = chosen(mask, then.y, y_[k]);
    vx_[k] = chosen(mask, then.vx, vx_[k]);
    vy_[k] = chosen(mask, then.vy, vy_[k]);
    speed_[k] = chosen(mask, then.speed, speed_[k]);
    time_[k] = chosen(mask, then.time, time_[k]);
    way_to_bump_[k] = chosen(mask, then.way_to_bump, way_to_bump_[k]);
    staying |= mask & bits[k];
  }
  return staying;
}

void GlideLanes::note_step(LaneSet lanes) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
    traces_[lane]->push_back({x_[lane], y_[lane], vx_[lane], vy_[lane]});
  }
}

auto GlideLanes::run_until_one_ends(const StopScope* stop) -> LaneSet {
  TALUS_PROMISE(!is_empty(), "there is a glide to run");
  constexpr unsigned stop_interval = 4096;  // steps between two looks at `stop`: below a millisecond
  LaneSet staying;
  unsigned steps = 0;
  do {
    staying = step_all();
    note_step(staying & traced_);
  } while (staying == occupied_ && (++steps % stop_interval != 0 || stop == nullptr || !stop->is_requested()));
  return occupied_ & ~staying;
}

}  // namespace talus
