#pragma once
// Several files and folders that are moved together: all of them, or none.

#include <filesystem>
#include <utility>
#include <vector>

namespace talus::server {

/// A move that fails throws BadInput. Unless they are kept, all moves are undone at the end.
class Moves {
 public:
  Moves() = default;
  Moves(const Moves&) = delete;
  Moves& operator=(const Moves&) = delete;
  ~Moves();

  /// Does nothing if there is no such file or folder. Expects that the new place is free.
  void move(const std::filesystem::path& from, const std::filesystem::path& to);
  void keep() { done_.clear(); }

 private:
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> done_;
};

}  // namespace talus::server
