#pragma once
// A good project, and the ways to spoil it in the tests of error messages.

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "support/projects.hpp"

namespace talus::project {

using testing_tools::refusal_of_reading;

/// A good project in 2D. The tests replace parts of it.
inline constexpr const char* good_project = R"(name = "Slope"

[analysis]
gravity_m_s2 = 9.81

[terrain]
section = [[0, 0], [10, -10], [20, -10]]

[[material]]
name = "Rock"
normal_restitution = 0.4
friction_angle_deg = 30

[[material]]
name = "Talus"
normal_restitution = 0.3

[ground]
segments = ["Rock", "Talus"]

[[seeder]]
name = "Crest"
position = [1, 5]
rocks = 10
mass_kg = 1000

[[barrier]]
name = "Fence"
line = 15
height_m = 3
)";

// Parts that are often replaced.
inline constexpr const char* section = "section = [[0, 0], [10, -10], [20, -10]]";
inline constexpr const char* segments = R"(segments = ["Rock", "Talus"])";

using Replacements = std::vector<std::pair<std::string, std::string>>;  // of the first part by the second

/// Replacements together with those that give positions and lines in 3D.
inline Replacements in_3d(Replacements replacements) {
  replacements.emplace_back("position = [1, 5]", "position = [1, 1, 5]");
  replacements.emplace_back("line = 15", "line = [[15, 0], [15, 50]]");
  return replacements;
}

struct BadProject {
  const char* name;
  Replacements replacements;  // in the good project
  std::string message;
};

inline void PrintTo(const BadProject& bad, std::ostream* out) { *out << bad.name; }

inline std::string changed(const Replacements& replacements) {
  std::string text = good_project;
  for (const auto& [from, to] : replacements) text = testing_tools::replaced(std::move(text), from, to);
  return text;
}

template <class Case>
std::string name_of_case(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class BadProjectTest : public testing::TestWithParam<BadProject> {};

}  // namespace talus::project
