// The house rules that the compiler does not know: which rooms know libraries of others, how headers are named, how
// large files may be. Reads the sources as text. That lower rooms do not know higher ones is for the build
// (rooms_test.cpp).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/places.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

// Libraries of file formats belong to these rooms, and nobody else has to be built against them; nor against MPI but
// campaign.
const std::set<std::string> rooms_of_formats{"gdal", "import", "layers", "maps", "export"};
constexpr std::array file_format_libraries{"gdal", "ogr", "cpl_", "proj.h", "assimp/", "httplib"};

constexpr std::size_t longest_file = 450;  // lines

struct Include {
  std::string name;
  std::size_t line = 0;
  bool is_quoted = false;
};

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<Include> includes_of(const std::vector<std::string>& lines) {
  std::vector<Include> includes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("<\"", word), close = line.find_first_of(">\"", open + 1);
    if (close != std::string::npos)
      includes.push_back({line.substr(open + 1, close - open - 1), i + 1, line[open] == '"'});
  }
  return includes;
}

// Why a file of `folder` may not include `name`, if it may not.
std::optional<std::string> objection(const std::string& folder, const Include& include) {
  const std::string& name = include.name;
  const bool is_of_a_format = std::any_of(file_format_libraries.begin(), file_format_libraries.end(),
                                          [&](const char* library) { return name.starts_with(library); });
  if (is_of_a_format && !rooms_of_formats.contains(folder))
    return "only gdal, import, layers, maps and export know GDAL";
  if (folder != "campaign" && name == "mpi.h") return "only campaign knows MPI";
  if (folder != "calibration" && folder != "meshing" && name.starts_with("Eigen/"))
    return "vectors are core/vec.hpp's; only calibration and meshing know Eigen";
  if (name.starts_with("oneapi/")) return "include <tbb/...>: the thread sanitizer's stands there (cmake/tsan)";
  if (name.ends_with(".hpp") && include.is_quoted && !name.starts_with("talus/"))
    return "a header of Talus is included as talus/ROOM/NAME.hpp";
  return std::nullopt;
}

std::vector<fs::path> sources(const fs::path& root) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".hpp" || extension == ".cpp")) files.push_back(entry.path());
  }
  return files;
}

const fs::path root = fs::path(talus::places::source_dir);

TEST(Architecture, RoomsIncludeOnlyWhatIsTheirs) {
  const fs::path source = root / "src" / "talus";
  std::size_t seen = 0;
  for (const fs::path& file : sources(source)) {
    const std::string folder = file.lexically_relative(source).begin()->string();
    for (const Include& include : includes_of(lines_of(file))) {
      ++seen;
      const auto why = objection(folder, include);
      EXPECT_FALSE(why) << file.string() << ':' << include.line << ": includes " << include.name << " (" << *why << ')';
    }
  }
  EXPECT_GT(seen, 100U);
}

// The rule must be able to fail.
TEST(Architecture, AWrongIncludeWouldBeFound) {
  EXPECT_TRUE(objection("results", {"gdal_priv.h"}));
  EXPECT_FALSE(objection("gdal", {"gdal_priv.h"}));
  EXPECT_TRUE(objection("project", {"mpi.h"}));
  EXPECT_FALSE(objection("campaign", {"mpi.h"}));
  EXPECT_TRUE(objection("rocks", {"Eigen/Dense"}));
  EXPECT_TRUE(objection("lines", {"oneapi/tbb/parallel_for.h"}));
  EXPECT_FALSE(objection("lines", {"tbb/parallel_for.h"}));
  EXPECT_TRUE(objection("rocks", {.name = "../campaign/campaign.hpp", .is_quoted = true}));
  EXPECT_FALSE(objection("rocks", {.name = "talus/core/vec.hpp", .is_quoted = true}));
  EXPECT_FALSE(objection("core", {"vector"}));
  const auto includes = includes_of({"// #include <a>", "#include <b>", " # include \"talus/c/d.hpp\"  // why"});
  ASSERT_EQ(includes.size(), 2U);
  EXPECT_EQ(includes[0].name, "b");
  EXPECT_EQ(includes[1].name, "talus/c/d.hpp");
  EXPECT_EQ(includes[1].line, 3U);
}

// Programs call the engine: what a rock does is settled below them.
TEST(Architecture, ProgramsHoldNoPhysics) {
  std::size_t seen = 0;
  for (const fs::path& file : sources(root / "app")) {
    for (const Include& include : includes_of(lines_of(file))) {
      ++seen;
      for (const char* law : {"impact", "sliding", "trajectory"})
        EXPECT_FALSE(include.name.starts_with(std::string("talus/") + law + '/'))
            << file.string() << ':' << include.line << ": includes " << include.name;
    }
  }
  EXPECT_GT(seen, 50U);
}

TEST(Architecture, HeadersAreIncludedOnce) {
  for (const char* part : {"src", "app", "test"}) {
    for (const fs::path& file : sources(root / part)) {
      if (file.extension() != ".hpp") continue;
      const auto lines = lines_of(file);
      EXPECT_TRUE(!lines.empty() && lines.front() == "#pragma once") << file << ":1: a header begins with #pragma once";
    }
  }
}

std::vector<fs::path> page_sources() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / "web" / "src"))
    if (entry.path().extension() == ".ts" || entry.path().extension() == ".tsx") files.push_back(entry.path());
  return files;
}

// The files of web/src that a file of it imports, as paths from there without their endings.
std::vector<std::string> imports_of(const fs::path& file, const fs::path& source) {
  static const std::regex pattern(R"(from '(\.[^']*)'|import\(?\s*'(\.[^']*)')");
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const fs::path folder = file.parent_path().lexically_relative(source);
  std::vector<std::string> imports;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match) {
    const std::string name = (*match)[1].matched ? (*match)[1].str() : (*match)[2].str();
    imports.push_back((folder / name).lexically_normal().generic_string());
  }
  return imports;
}

// A file that a walk along imports comes back to while it is still on the way; nothing where there is no such circle.
std::optional<std::string> circle_in(const std::map<std::string, std::vector<std::string>>& imports) {
  std::map<std::string, int> state;  // 1: on the way; 2: done
  std::optional<std::string> found;
  const std::function<void(const std::string&)> walk = [&](const std::string& name) {
    state[name] = 1;
    if (const auto entry = imports.find(name); entry != imports.end())
      for (const std::string& next : entry->second) {
        if (state[next] == 0) walk(next);
        if (state[next] == 1 && !found) found = name + " -> " + next;
      }
    state[name] = 2;
  };
  for (const auto& [name, unused] : imports)
    if (state[name] == 0) walk(name);
  return found;
}

TEST(Architecture, FilesOfThePageImportNoCircle) {
  const fs::path source = root / "web" / "src";
  std::map<std::string, std::vector<std::string>> imports;
  std::size_t seen = 0;
  for (const fs::path& file : page_sources()) {
    auto names = imports_of(file, source);
    seen += names.size();
    imports.emplace(file.lexically_relative(source).replace_extension().generic_string(), std::move(names));
  }
  EXPECT_GT(seen, 500U);
  EXPECT_EQ(circle_in(imports), std::nullopt);
  EXPECT_TRUE(circle_in({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}}));
  EXPECT_FALSE(circle_in({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}}));
}

// Names in a project are the user's, and may be anybody's: the page shows them as text.
TEST(Architecture, ThePageMakesNoMarkupOfTexts) {
  const auto files = page_sources();
  EXPECT_GT(files.size(), 20U);
  for (const fs::path& file : files) {
    const auto lines = lines_of(file);
    for (std::size_t k = 0; k < lines.size(); ++k)
      for (const char* word : {"innerHTML", "InnerHTML", "outerHTML", "insertAdjacentHTML", "document.write"})
        EXPECT_EQ(lines[k].find(word), std::string::npos) << file.string() << ':' << k + 1 << ": " << word;
  }
}

TEST(Architecture, FilesOfTheSourceStaySmall) {
  for (const fs::path& file : page_sources())
    EXPECT_LE(lines_of(file).size(), longest_file) << file << " has outgrown one idea";
  for (const char* part : {"src", "app"}) {
    for (const fs::path& file : sources(root / part))
      EXPECT_LE(lines_of(file).size(), longest_file) << file << " has outgrown one idea";
  }
}

}  // namespace
}  // namespace talus
