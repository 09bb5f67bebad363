#pragma once
// The errors and warnings of one mesh file. Errors are collected as long as reading makes sense, so that the user sees
// many at once.

#include <cstdint>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"

namespace talus {

/// A place in a mesh file: a line of a text format, or an element such as "face 3 of 12" of a binary one.
struct MeshPlace {
  std::uint32_t line = 0;  // 1-based; 0 in a file without lines
  std::string where;
};

class MeshProblems {
 public:
  /// Reading stops after this many errors: a bad file may have one in each of a million lines.
  static constexpr std::size_t most_errors = 20;

  explicit MeshProblems(std::string file) : file_(std::move(file)) {}

  /// Adds an error. Throws BadInput with all errors if there are too many to continue.
  void refuse(const MeshPlace& place, std::string what, std::string why, std::string hint = "");
  /// Adds an error after which reading cannot continue, and throws BadInput with all errors.
  [[noreturn]] void stop(const MeshPlace& place, std::string what, std::string why, std::string hint = "");
  void warn(const MeshPlace& place, std::string what, std::string why, std::string hint = "");
  /// Throws BadInput if there are errors.
  void throw_if_any() const;

  [[nodiscard]] const Problems& warnings() const { return warnings_; }

 private:
  [[nodiscard]] Problem problem(const MeshPlace& place, std::string what, std::string why, std::string hint) const;

  std::string file_;
  Problems errors_;
  Problems warnings_;
};

/// Warns if 32-bit floats as large as `largest` [m] are more than a millimetre apart.
void warn_of_single_precision(float largest, MeshProblems& problems);

/// Text from a file as a message may quote it: in quotes, at most 40 characters, with `?` for those that do not print.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace talus
