// All links between pages of the documentation are valid, and its index lists every page.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/places.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;

const fs::path root = talus::places::source_dir;

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// All pages below docs.
std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  return found;
}

/// The anchors of a page's headings, as GitHub forms them.
std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& line : lines_of(page)) {
    const std::size_t text = line.find_first_not_of('#');
    if (text == 0 || text == std::string::npos || line[text] != ' ') continue;
    std::string anchor;
    for (const char c : line.substr(text + 1)) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      } else if (c == ' ') {
        anchor += '-';
      }
    }
    anchors.insert(anchor);
  }
  return anchors;
}

std::vector<std::string> links_of(const fs::path& page) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  std::vector<std::string> links;
  for (const std::string& line : lines_of(page)) {
    for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it) links.push_back((*it)[1]);
  }
  return links;
}

std::vector<std::string> broken_links_of(const fs::path& page) {
  std::vector<std::string> broken;
  for (const std::string& link : links_of(page)) {
    if (link.starts_with("http")) continue;
    const std::size_t hash = link.find('#');
    const fs::path file = hash == 0 ? page : page.parent_path() / link.substr(0, hash);
    const bool is_valid =
        fs::exists(file) && (hash == std::string::npos || anchors_of(file).contains(link.substr(hash + 1)));
    if (!is_valid) broken.push_back(link);
  }
  return broken;
}

TEST(DocumentationLinks, AreValid) {
  std::vector<fs::path> all = pages();
  for (const char* name :
       {"README.md", "ARCHITECTURE.md", "EXTENDING.md", "CONTRIBUTING.md", "CHANGELOG.md", "web/README.md"}) {
    all.push_back(root / name);
  }
  EXPECT_GT(all.size(), 15U);
  for (const fs::path& page : all) EXPECT_THAT(broken_links_of(page), IsEmpty()) << page;
}

TEST(DocumentationIndex, ListsEveryPage) {
  const fs::path index = root / "docs/README.md";
  std::set<fs::path> listed{index};
  for (const std::string& link : links_of(index)) listed.insert((index.parent_path() / link).lexically_normal());
  for (const fs::path& page : pages()) EXPECT_TRUE(listed.contains(page)) << page << " is not in docs/README.md";
}

}  // namespace
}  // namespace talus
