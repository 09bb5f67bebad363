#pragma once
// Writes trajectories.bin; trajectory_store.hpp reads it. docs/trajectories.md describes the file.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "talus/store/store_facts.hpp"

namespace talus {

inline constexpr std::string_view store_magic = "talus trajectory";
inline constexpr std::uint32_t store_format = 2;  // 1: the same without blocks

/// A rock as bytes, which belong to others: first its cells as runs (cell_set.hpp), then its path (path_code.hpp).
struct StoredRock {
  std::uint64_t rock = 0;
  std::uint32_t rows = 0;  // of paths.csv
  std::uint32_t cells_size = 0, path_size = 0;
  const char* bytes = nullptr;

  [[nodiscard]] std::size_t size() const { return std::size_t{cells_size} + path_size; }
  [[nodiscard]] std::string_view cells() const { return {bytes, cells_size}; }
  [[nodiscard]] std::string_view path() const { return {bytes + cells_size, path_size}; }
};

/// How many rocks a store has, for people.
struct StoreExtent {
  std::uint64_t rocks = 0, rows = 0;  // rows of paths.csv
  std::uint64_t bytes = 0;            // of the file
};

/// `rocks`: in the order of their numbers. `done`: the rocks of the run so far. Throws BadInput if that fails.
StoreExtent write_store(const std::filesystem::path& file, const StoreFacts& facts, std::uint64_t done,
                        std::span<const StoredRock> rocks);

}  // namespace talus
