#pragma once
// Writes trajectories.bin; trajectory_store.hpp reads it. docs/trajectories.md describes the file.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talus/store/store_facts.hpp"
#include "talus/store/store_observer.hpp"

namespace talus {

inline constexpr std::string_view store_magic = "talus trajectory";
inline constexpr std::uint32_t store_format = 1;

class StoreFile {
 public:
  /// `done`: the rocks of the run so far.
  StoreFile(const StoreFacts& facts, std::uint64_t done);

  /// A rock, in the order of their numbers; `path` must outlive this object. `cells`: as runs (cell_set.hpp).
  void add(std::uint64_t rock, std::uint32_t rows, std::string_view cells, std::string_view path);
  /// Throws BadInput if that fails.
  StoreExtent write(const std::filesystem::path& file) const;

 private:
  StoreFacts facts_;
  std::uint64_t done_, rows_ = 0;
  double largest_radius_ = 0;
  std::vector<std::uint64_t> rocks_;
  std::vector<std::string_view> paths_;
  std::string cells_;
};

}  // namespace talus
