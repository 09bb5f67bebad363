#pragma once
// A page of docs/guides as a script: the files it shows are written, its commands are run, and their output is compared
// with what the page shows.
//
//   ```toml slope.toml       a block with a file name is a file; the paragraph before the block names it, too
//   ```console               commands after "$ " (a backslash continues one on the next line), each with its output
//
// Other blocks are refused: nothing on such a page goes unchecked.

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace talus::test {

/// Lines outside blocks.
struct Prose {
  std::vector<std::string> lines;
};

struct ShownFile {
  std::string language;  // of its colours: toml, csv, sh
  std::string name;
  std::string text;
};

struct Command {
  std::vector<std::string> lines;  // as on the page, without "$ "
  std::string output;              // as on the page; what differs from run to run as "..."

  /// For a shell.
  [[nodiscard]] std::string text() const;
};

struct Console {
  std::vector<Command> commands;
};

struct GuidePage {
  std::vector<std::variant<Prose, ShownFile, Console>> parts;

  /// The page again: the text that it was read from, but for the output of its commands.
  [[nodiscard]] std::string text() const;
  /// Everything that is checked: files, commands and outputs.
  [[nodiscard]] std::string checked_text() const;
};

/// Throws std::runtime_error with the line where a block is none of the above.
[[nodiscard]] GuidePage read_guide(const std::string& text);

/// Output as pages show it: how long a run took and on how many threads is "...".
[[nodiscard]] std::string as_shown(const std::string& output);

/// Numbers in the page's prose that no file, command or output of the page has. A number of prose may be rounded, and
/// may be the percentage of a share. What is part of a word (3D, p95, 95th) is none, and neither is a link's address.
[[nodiscard]] std::vector<std::string> numbers_from_nowhere(const GuidePage& page);

}  // namespace talus::test
