#pragma once
// What a store says about its run.

#include <cstdint>
#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/bytes.hpp"
#include "talus/core/vec.hpp"
#include "talus/store/store_grid.hpp"

namespace talus {

struct StoreFacts {
  bool is_section = false;  // 2D: y is 0
  bool is_sphere = false;   // rigid sphere or block; otherwise a rock is its centre
  bool has_blocks = false;  // some rocks have shapes
  Vec3 origin;              // of the local frame, in the project's coordinates [m]
  Vec3 gravity;             // [m/s2]
  double energy_datum = 0;  // z in the project's coordinates [m]
  std::uint64_t seed = 0;
  std::uint64_t planned = 0;                             // rocks of the whole campaign
  std::uint64_t ensembles = 0;                           // 0: all rocks have the same parameters
  std::vector<std::string> seeders, sources, materials;  // names, by SeederId, SourceId, MaterialId
  StoreGrid grid;                                        // of the index

  [[nodiscard]] static StoreFacts of(const Model& model);
  void save(ByteWriter& out) const;
  /// Throws BadBytes.
  [[nodiscard]] static StoreFacts read(ByteReader& in);
};

}  // namespace talus
