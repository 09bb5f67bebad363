#include "docs/guide_page.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace talus::test {

namespace {

constexpr std::string_view fence = "```";

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// The rest of the line that opens a block, after "```", and the lines of the block.
struct Block {
  std::string head;
  std::vector<std::string> lines;
};

Console console_of(const Block& block) {
  Console console;
  bool continues = false;
  for (const std::string& line : block.lines) {
    const bool begins = !continues && line.starts_with("$ ");
    if (begins) console.commands.emplace_back();
    if (console.commands.empty()) throw std::runtime_error("a console begins with \"$ \", not with: " + line);
    Command& command = console.commands.back();
    if (begins || continues) {
      command.lines.push_back(begins ? line.substr(2) : line);
      continues = line.ends_with('\\');
    } else {
      command.output += line + "\n";
    }
  }
  return console;
}

std::variant<Prose, ShownFile, Console> part_of(const Block& block, const std::string& paragraph_before) {
  if (block.head == "console") return console_of(block);
  const std::size_t space = block.head.find(' ');
  if (space == std::string::npos) throw std::runtime_error("a block without a file name: " + block.head);
  ShownFile file{block.head.substr(0, space), block.head.substr(space + 1), joined(block.lines)};
  if (paragraph_before.find("`" + file.name + "`") == std::string::npos) {
    throw std::runtime_error("the paragraph before the block does not name `" + file.name + "`");
  }
  return file;
}

struct Number {
  std::string text;  // without commas between thousands
  double value = 0;
  int decimals = 0;
};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word_character(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Numbers without their signs. `in_words`: include those within words (`p95`, `3D`, `maps-2.tif`).
std::vector<Number> numbers_in(const std::string& text, bool in_words) {
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    const std::size_t begin = i;
    std::string digits;
    int decimals = 0;
    for (bool after_point = false; i < text.size(); ++i) {
      const bool digit_follows = i + 1 < text.size() && is_digit(text[i + 1]);
      if (is_digit(text[i])) {
        digits += text[i];
        decimals += after_point ? 1 : 0;
      } else if (text[i] == '.' && digit_follows && !after_point) {
        digits += '.';
        after_point = true;
      } else if (!(text[i] == ',' && digit_follows && !in_words)) {
        break;
      }
    }
    const bool is_in_word =
        (begin > 0 && is_word_character(text[begin - 1])) || (i < text.size() && is_word_character(text[i]));
    if (in_words || !is_in_word) numbers.push_back({digits, std::stod(digits), decimals});
  }
  return numbers;
}

bool rounds_to(double value, const Number& number) {
  const double step = std::pow(10.0, -number.decimals);
  return std::abs(value - number.value) <= 0.5 * step * (1 + 1e-9);
}

}  // namespace

std::string Command::text() const { return joined(lines); }

std::string GuidePage::text() const {
  std::string text;
  for (const auto& part : parts) {
    if (const auto* prose = std::get_if<Prose>(&part)) {
      text += joined(prose->lines);
    } else if (const auto* file = std::get_if<ShownFile>(&part)) {
      text += std::string(fence) + file->language + " " + file->name + "\n" + file->text + std::string(fence) + "\n";
    } else {
      text += std::string(fence) + "console\n";
      for (const Command& command : std::get<Console>(part).commands) text += "$ " + command.text() + command.output;
      text += std::string(fence) + "\n";
    }
  }
  return text;
}

std::string GuidePage::checked_text() const {
  std::string text;
  for (const auto& part : parts) {
    if (const auto* file = std::get_if<ShownFile>(&part)) text += file->text;
    if (const auto* console = std::get_if<Console>(&part)) {
      for (const Command& command : console->commands) text += command.text() + command.output;
    }
  }
  return text;
}

GuidePage read_guide(const std::string& text) {
  GuidePage page;
  Prose prose;
  std::istringstream in(text);
  std::size_t line_number = 0;
  std::string paragraph;  // the latest
  bool paragraph_ends = false;
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (!line.starts_with(fence)) {
      prose.lines.push_back(line);
      if (line.empty()) {
        paragraph_ends = true;
      } else {
        if (paragraph_ends) paragraph.clear();
        paragraph_ends = false;
        paragraph += line + "\n";
      }
      continue;
    }
    const std::size_t begin = line_number;
    Block block{line.substr(fence.size()), {}};
    bool ends = false;
    while (!ends && std::getline(in, line)) {
      ++line_number;
      ends = line == fence;
      if (!ends) block.lines.push_back(line);
    }
    if (!ends) throw std::runtime_error("line " + std::to_string(begin) + ": the block has no end");
    page.parts.emplace_back(std::move(prose));
    prose = {};
    try {
      page.parts.push_back(part_of(block, paragraph));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(begin) + ": " + error.what());
    }
  }
  page.parts.emplace_back(std::move(prose));
  return page;
}

std::string as_shown(const std::string& output) {
  static const std::regex timing(R"(in [0-9.]+ s \([0-9]+ rocks/s on [0-9]+ threads?( of [0-9]+ ranks)?\))");
  static const std::regex progress(R"([0-9]+ of [0-9]+ [a-z ]+ \([0-9]+ %\), [0-9.]+ [a-z ]+/s, [^\n]* left\n)");
  return std::regex_replace(std::regex_replace(output, progress, ""), timing,
                            "in ... s (... rocks/s on ... threads$1)");
}

std::vector<std::string> unsupported_numbers(const GuidePage& page) {
  static const std::regex address(R"(\]\([^)]*\))");
  const std::vector<Number> known = numbers_in(page.checked_text(), true);
  std::vector<std::string> unknown;
  for (const auto& part : page.parts) {
    const auto* prose = std::get_if<Prose>(&part);
    if (prose == nullptr) continue;
    for (const std::string& line : prose->lines) {
      for (const Number& number : numbers_in(std::regex_replace(line, address, "]"), false)) {
        const bool found = std::ranges::any_of(known, [&](const Number& one) {
          return rounds_to(one.value, number) || (one.value < 1 && rounds_to(100 * one.value, number));
        });
        if (!found) unknown.push_back(number.text + " in: " + line);
      }
    }
  }
  return unknown;
}

}  // namespace talus::test
