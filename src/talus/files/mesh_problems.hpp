#pragma once
// What is wrong with one mesh file: errors are collected until reading has no more sense, so that the user sees many at
// once; warnings do not stop it.

#include <cstdint>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"

namespace talus {

/// Where in a mesh file: a line of a text format, or a thing such as "face 3 of 12" of a binary one.
struct MeshPlace {
  std::uint32_t line = 0;  // 1-based; 0 where there are no lines
  std::string where;
};

class MeshProblems {
 public:
  /// After so many errors reading stops: a wrong file would have one in each of its million lines.
  static constexpr std::size_t most_errors = 20;

  explicit MeshProblems(std::string file) : file_(std::move(file)) {}

  /// Notes an error. Throws BadInput with all of them when there are too many to go on.
  void refuse(const MeshPlace& place, std::string what, std::string why, std::string hint = "");
  /// Notes an error after which nothing more can be understood, and throws BadInput with all of them.
  [[noreturn]] void stop(const MeshPlace& place, std::string what, std::string why, std::string hint = "");
  void warn(const MeshPlace& place, std::string what, std::string why, std::string hint = "");
  /// Throws BadInput when there was an error.
  void throw_if_any() const;

  [[nodiscard]] const Problems& warnings() const { return warnings_; }

 private:
  [[nodiscard]] Problem problem(const MeshPlace& place, std::string what, std::string why, std::string hint) const;

  std::string file_;
  Problems errors_;
  Problems warnings_;
};

/// Warns when coordinates as large as `largest` [m], kept as 32-bit floats, stand more than a millimetre apart.
void warn_of_single_precision(float largest, MeshProblems& problems);

/// Foreign text made fit for a message: in quotes, at most 40 bytes, anything unprintable as `?`.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace talus
