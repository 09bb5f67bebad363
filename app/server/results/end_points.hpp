#pragma once
// The rocks of a run's tables, as arrays.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/run_summary.hpp"
#include "talus/archive/run_facts.hpp"
#include "talus/core/vec.hpp"

namespace talus::server {

struct EndPoints {
  std::uint64_t total = 0;  // number of rocks from which these were chosen
  Vec3 origin;              // of the positions [m]

  std::vector<std::uint32_t> rocks;
  std::vector<float> positions;  // of the ends, three each [m]
  std::vector<std::uint16_t> sources, seeders;
  std::vector<std::uint8_t> reasons;
  std::vector<float> masses;            // [kg]
  std::vector<float> radii;             // of the equivalent spheres [m]
  std::vector<float> max_energies;      // kinetic [kJ]
  std::vector<float> max_heights;       // above the ground [m]
  std::vector<std::uint32_t> barriers;  // bit k: hit barrier k; as many words per rock as the barriers need

  Names source_names, seeder_names;
  std::vector<std::string> barrier_names;
};

using RockTest = std::function<bool(std::uint64_t rock)>;

/// `rocks` rocks of a finished run, evenly spread over those in its table that pass the test (empty: all). Throws
/// BadInput if a table is damaged.
[[nodiscard]] EndPoints end_points(const std::filesystem::path& folder, const RunFacts& facts, std::uint64_t rocks,
                                   const RockTest& passes = {});

/// `wanted` of the rocks that are in a table and pass a test (empty: all), evenly spread.
class ChosenRocks {
 public:
  /// `before(rock)`: how many rocks below this number are in the table; `has(rock)`: whether this one is.
  ChosenRocks(std::uint64_t wanted, std::uint64_t done, const std::function<std::uint64_t(std::uint64_t)>& before,
              const RockTest& has, const RockTest& passes);
  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] const RockTest& wants() const { return wants_; }

 private:
  std::uint64_t total_ = 0;
  RockTest wants_;
};

/// The rocks for which `wants` is true; it is called in ascending order.
[[nodiscard]] EndPoints end_points(const std::filesystem::path& folder, const RunFacts& facts,
                                   const std::function<bool(std::uint64_t rock)>& wants);

/// The place rounded to whole metres: coordinates relative to it are accurate to a millimetre as float.
[[nodiscard]] inline Vec3 origin_near(const Vec3& place) { return place.rounded(); }

}  // namespace talus::server
