// The worked example of docs/barrier-design.md: its settings, read by the program, give its results.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include "support/places.hpp"
#include "support/projects.hpp"
#include "talus/model/design_plan.hpp"

namespace talus::project {
namespace {

using testing_tools::model_of;

TEST(BarrierDesignPage, HasAnExampleThatTheProgramAgreesWith) {
  std::ifstream in(talus::places::in_source("/docs/barrier-design.md"));
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::string example = page.substr(page.find("## A worked example"));
  const std::string fence = "```toml\n";
  const std::size_t begin = example.find(fence) + fence.size();
  const std::string settings = example.substr(begin, example.find("```", begin) - begin);
  const std::string text = R"([terrain]
section = [[0, 0], [30, -20]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, 5]
mass_kg = 1000
[[collector]]
line = 20
height_m = 5
)" + settings;
  const CheckFactors factors = design_plan(read_project_text(text, "slope.toml").project, model_of(text)).factors;
  ASSERT_EQ(factors.block_mass, 1500);
  const auto states = [&](const std::string& result) {
    EXPECT_NE(example.find("| " + result), std::string::npos) << result;
  };
  const double velocity = 18, height = 2.4, clearance = 6;
  const double rock = 100, rock_radius = std::cbrt(3 * rock / (4 * std::numbers::pi * 2700));
  const double radius = radius_to_check(factors, rock, rock_radius);
  EXPECT_NE(example.find(fmt::format("r = {:.3f} m", radius)), std::string::npos);
  states(fmt::format("{:.3f} m/s |", velocity * factors.velocity));
  states(fmt::format("{:.1f} kg |", *factors.block_mass * factors.mass));
  const double needed = needed_maximum_energy(factors, energy_to_check(factors, 0, 0, velocity));
  states(fmt::format("{:.2f} kJ |", needed / factors.capacity / 1000));
  states(fmt::format("{:.2f} kJ: class {} |", needed / 1000, needed_class(factors, needed)));
  states(fmt::format("{:.3f} m |", (height - radius) * factors.height));
  states(fmt::format("{:.3f} m |", needed_height(factors, height - 2 * radius, radius)));
  const double net = *needed_clearance(factors, 4.2);
  states(fmt::format("{:.3f} m |", net));
  states(fmt::format("{}; at most {:.3f} m in the test |", net <= clearance ? "passes" : "fails",
                     *most_elongation(factors, clearance)));
}

}  // namespace
}  // namespace talus::project
