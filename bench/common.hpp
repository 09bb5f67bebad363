#pragma once
// What every benchmark prints: its input, a hash of its result, its speed.

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <cstdint>

#include "talus/campaign/campaign.hpp"
#include "talus/results/record.hpp"

namespace talus::bench {

/// A hash of the bits of all end points, in the order of the rocks, and counts.
class EndHash : public Observer {
 public:
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(); }
  void commit(ObserverPart& part) override {
    const Part& seen = static_cast<Part&>(part);
    for (const Vec3& end : seen.ends) {
      for (const double x : {end.x(), end.y(), end.z()})
        hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
    }
    rocks += seen.ends.size();
    events += seen.events;
    for (std::size_t k = 0; k < reasons.size(); ++k) reasons[k] += seen.reasons[k];
  }
  [[nodiscard]] std::uint64_t hash() const { return hash_; }

  std::uint64_t rocks = 0;
  std::int64_t events = 0;
  std::array<std::uint64_t, end_reason_count> reasons{};

 private:
  struct Part : ObserverPart {
    void see(const RockRecord& record, const RockLog&) override {
      ends.push_back(record.outcome.end.position);
      events += record.outcome.events;
      ++reasons[static_cast<std::size_t>(record.outcome.reason)];
    }
    std::vector<Vec3> ends;
    std::int64_t events = 0;
    std::array<std::uint64_t, end_reason_count> reasons{};
  };
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

/// The duration of `work` [s].
template <class Work>
[[nodiscard]] double seconds(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline void print_reasons(const EndHash& result) {
  for (int k = 0; k < end_reason_count; ++k) {
    const auto count = result.reasons[static_cast<std::size_t>(k)];
    if (count > 0) fmt::print("  ended {}: {}\n", name(static_cast<EndReason>(k)), count);
  }
}

}  // namespace talus::bench
