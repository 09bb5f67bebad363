#pragma once
// The errors of one file, of which only the first few are reported: a bad file may have one in each of a million lines.

#include <cstddef>
#include <string>
#include <utility>

#include "talus/core/problems.hpp"

namespace talus {

class FirstProblems {
 public:
  static constexpr std::size_t most_reported = 10;

  /// `things` have the errors, for messages: "lines", "features".
  FirstProblems(std::string file, std::string things) : file_(std::move(file)), things_(std::move(things)) {}

  void add(int line, std::string what, std::string why, std::string hint = "");
  [[nodiscard]] bool any() const { return count_ > 0; }
  /// Throws BadInput with the first errors and the number of the others, if there are any.
  void throw_if_any() const;

 private:
  std::string file_, things_;
  Problems first_;
  std::size_t count_ = 0;
};

}  // namespace talus
