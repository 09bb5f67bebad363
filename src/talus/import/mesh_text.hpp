#pragma once
// Lines, words and numbers of the text formats of meshes. Numbers are read by std::from_chars: correctly rounded to
// double, and the same in every locale.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "talus/files/mesh_problems.hpp"

namespace talus {

/// Iterates over the lines of a text. A line ends in LF or CR LF, neither of which `next` returns.
class Lines {
 public:
  explicit Lines(std::string_view text, std::uint32_t lines_before = 0) : rest_(text), number_(lines_before) {}

  [[nodiscard]] std::optional<std::string_view> next();
  [[nodiscard]] std::uint32_t number() const { return number_; }  // of the line last returned by `next`, from 1
  [[nodiscard]] std::string_view rest() const { return rest_; }   // the text after that line

 private:
  std::string_view rest_;
  std::uint32_t number_;
};

/// Removes the first word from the front of `line` and returns it; empty at the end. Blanks and tabs separate words.
[[nodiscard]] std::string_view take_word(std::string_view& line);

/// The word with ASCII letters in lower case.
[[nodiscard]] std::string lower(std::string_view word);

/// A coordinate in metres; if `word` is none, nullopt, with an error in `problems`.
[[nodiscard]] std::optional<double> read_coordinate(std::string_view word, MeshProblems& problems,
                                                    const MeshPlace& place);

/// The integer that `word` consists of; nullopt if it is none or does not fit into 64 bits.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view word);

}  // namespace talus
