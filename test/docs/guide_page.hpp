#pragma once
// A page of docs/guides as a script: the files on the page are written, its commands are run, and their output is
// compared with that on the page.
//
//   ```toml slope.toml       a block with a file name is a file; the paragraph before the block also names it
//   ```console               commands after "$ " (a backslash continues one on the next line), each with its output
//
// Other blocks are refused, so that everything on such a page is checked.

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
  std::string language;  // for syntax highlighting: toml, csv, sh
  std::string name;
  std::string text;
};

struct Command {
  std::vector<std::string> lines;  // as on the page, without "$ "
  std::string output;              // as on the page, with "..." for text that differs between runs

  /// The command for a shell.
  [[nodiscard]] std::string text() const;
};

struct Console {
  std::vector<Command> commands;
};

struct GuidePage {
  std::vector<std::variant<Prose, ShownFile, Console>> parts;

  /// The text of the page, with the current `output` of its commands.
  [[nodiscard]] std::string text() const;
  /// All text that is checked: files, commands and outputs.
  [[nodiscard]] std::string checked_text() const;
};

/// Throws std::runtime_error with the line of a block that is neither a file nor a console.
[[nodiscard]] GuidePage read_guide(const std::string& text);

/// Output as pages show it: durations and numbers of threads are replaced by "...", progress is left out.
[[nodiscard]] std::string as_shown(const std::string& output);

/// Numbers in the page's prose that are in none of its files, commands and outputs. They may be rounded, or be the
/// percentage of a share. Numbers in words (3D, p95, 95th) and in addresses of links do not count.
[[nodiscard]] std::vector<std::string> unsupported_numbers(const GuidePage& page);

}  // namespace talus::test
