#pragma once
// What the tables of a run say of its rocks one by one, as arrays.

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
  std::uint64_t total = 0;     // from which the rocks were chosen
  Vec3 origin = Vec3::Zero();  // to which positions are relative [m]

  std::vector<std::uint32_t> rocks;
  std::vector<float> positions;  // of the ends, three each [m]
  std::vector<std::uint16_t> sources, seeders;
  std::vector<std::uint8_t> reasons;
  std::vector<float> masses;            // [kg]
  std::vector<float> radii;             // of the equivalent spheres [m]
  std::vector<float> max_energies;      // kinetic [kJ]
  std::vector<float> max_heights;       // above the ground [m]
  std::vector<std::uint32_t> barriers;  // bit k: it hit the k-th; so many words a rock as barriers need

  Names source_names, seeder_names;
  std::vector<std::string> barrier_names;
};

/// So many rocks of a finished run, evenly spread over their numbers. Throws BadInput where a table is damaged.
[[nodiscard]] EndPoints end_points(const std::filesystem::path& folder, const RunFacts& facts, std::uint64_t rocks);

/// Those that are wanted, of rocks in ascending order.
[[nodiscard]] EndPoints end_points(const std::filesystem::path& folder, const RunFacts& facts,
                                   const std::function<bool(std::uint64_t rock)>& wants);

/// Whole metres near a place: what is relative to it keeps its millimetres as a float.
[[nodiscard]] inline Vec3 origin_near(const Vec3& place) { return place.array().round(); }

}  // namespace talus::server
