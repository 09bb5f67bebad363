#pragma once
// All files of a run's folder, for comparing runs.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace talus::test {

/// The tutorial's slope in 3D with a barrier that some rocks break through, a collector, both with a design, and two
/// sources of rocks.
inline std::string write_slope_with_barrier(const Workplace& work) {
  std::ifstream in(tutorial("3d"));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text += R"(
[[barrier]]
name = "Fence"
line = [[12, 0], [12, 35]]
height_m = 1.5
capacity_kJ = 60

[[seeder]]
name = "Ledge"
type = "point"
position = [5, 20, -11]
rocks = 25
mass_kg = { mean = 400, distribution = "normal", std_dev = 80, rel_min = 240, rel_max = 240 }
horizontal_velocity_m_s = 2

[design]
section_m = 4
)";
  return work.write("slope.toml", text);
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Contents by path in the folder, without the parts that may differ between two runs of one project: timings, and in
/// the report the date and the folder's name.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::string bytes = bytes_of(entry.path());
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    if (name == "summary.json") {
      auto json = nlohmann::ordered_json::parse(bytes);
      json.erase("timings");
      bytes = json.dump(1);
    } else if (name == "files.json") {
      auto json = nlohmann::ordered_json::parse(bytes);
      for (const char* varies : {"summary.json", "report.html"}) json.at("files").erase(varies);
      bytes = json.dump(1);
    } else if (name == "report.html") {
      for (const char* varies : {R"("timings":\{[^}]*\})", R"("date":"[^"]*")", R"("folder":"[^"]*")"}) {
        bytes = std::regex_replace(bytes, std::regex(varies), "");
      }
    }
    files[name] = std::move(bytes);
  }
  return files;
}

/// Lists the files that are missing in one of two folders or that differ; empty if the folders are the same.
inline std::string differences(const std::map<std::string, std::string>& a,
                               const std::map<std::string, std::string>& b) {
  std::string text;
  for (const auto& [name, bytes] : a) {
    const auto found = b.find(name);
    if (found == b.end()) {
      text += name + " is missing; ";
    } else if (found->second != bytes) {
      text += name + " differs; ";
    }
  }
  for (const auto& [name, bytes] : b) {
    if (!a.contains(name)) text += name + " is additional; ";
  }
  return text;
}

}  // namespace talus::test
