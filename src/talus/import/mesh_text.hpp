#pragma once
// Lines, words and numbers of the text formats of meshes. Numbers are read by std::from_chars: correctly rounded to
// double, and the same in every locale.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "talus/files/mesh_problems.hpp"

namespace talus {

/// Walks through the lines of a text. A line ends in LF or CR LF; neither is part of what `next` gives.
class Lines {
 public:
  explicit Lines(std::string_view text, std::uint32_t lines_before = 0) : rest_(text), number_(lines_before) {}

  [[nodiscard]] std::optional<std::string_view> next();
  [[nodiscard]] std::uint32_t number() const { return number_; }  // of the line that `next` gave last, from 1
  [[nodiscard]] std::string_view rest() const { return rest_; }   // what follows that line

 private:
  std::string_view rest_;
  std::uint32_t number_;
};

/// Takes the first word off the front of `line`; empty at its end. Blanks and tabs stand between words.
[[nodiscard]] std::string_view take_word(std::string_view& line);

/// ASCII letters made small: the keywords of STL and the names' endings are written both ways.
[[nodiscard]] std::string lower(std::string_view word);

/// A coordinate in metres, or a note in `problems` why `word` is none.
[[nodiscard]] std::optional<double> read_coordinate(std::string_view word, MeshProblems& problems,
                                                    const MeshPlace& place);

/// A whole number that fits 64 bits, with nothing before or after it.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view word);

}  // namespace talus
