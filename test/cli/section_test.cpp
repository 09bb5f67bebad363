// `talus section`: what it writes is a section that a project can name, and what it refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cli/program.hpp"
#include "support/places.hpp"

namespace talus::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* roof =
    "v 0 0 50\nv 100 0 90\nv 100 200 90\nv 0 200 50\nv 160 0 60\nv 160 200 60\n"
    "f 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n";

TEST(SectionCommand, WritesATableThatAProjectCanName) {
  const Workplace place;
  const std::string mesh = place.write("roof.obj", roof);
  const Said said = talus_says("section " + mesh + " --crs local --line '10,20 130,20' --tolerance 0.01 -o " +
                               (place / "profile.csv").string());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("3 vertices over 120 m. In a project: section = \"profile.csv\""));
  EXPECT_EQ(place.read("profile.csv"),
            "distance_m,z_m,x_m,y_m\n0.0000,54.0000,10.0000,20.0000\n90.0000,90.0000,100.0000,20.0000\n"
            "120.0000,75.0000,130.0000,20.0000\n");
  const std::string project = place.write("slope.toml",
                                          "[terrain]\nsection = \"profile.csv\"\n[[material]]\nname = \"Rock\"\n"
                                          "roughness_deg = 2\n[[seeder]]\nposition = [80, \"surface\"]\n"
                                          "rocks = 5\nmass_kg = 100\nhorizontal_velocity_m_s = 2\n");
  EXPECT_THAT(talus_says("check " + project).text, HasSubstr("no errors; 5 rocks"));
}

TEST(SectionCommand, PrintsTheTableIfNoFileIsNamed) {
  const Workplace place;
  const Said said = talus_says("section " + place.write("roof.obj", roof) + " --crs local --line '10,20 130,20'");
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.text, StartsWith("distance_m,z_m,x_m,y_m\n0.0000,54.0000,"));
}

TEST(SectionCommand, RefusesWhatItWouldIgnoreOrDestroy) {
  const Workplace place;
  const std::string project = talus::places::in_source("/examples/maungawhau/maungawhau.toml");
  const std::string cut = "section " + project + " --line '290,120 300,40'";
  const Said with_crs = talus_says(cut + " --crs EPSG:2193");
  EXPECT_EQ(with_crs.exit_code, 2);
  EXPECT_THAT(with_crs.text, HasSubstr("--crs: is given for a project (a project names its own coordinate system)"));
  const Said over_another = talus_says(cut + " -o " + place.write("notes.txt", "mine\n"));
  EXPECT_EQ(over_another.exit_code, 2);
  EXPECT_EQ(place.read("notes.txt"), "mine\n");
  const Said of_section = talus_says("section " + tutorial("2d") + " --line '0,0 1,1'");
  EXPECT_EQ(of_section.exit_code, 2);
  EXPECT_THAT(of_section.text, HasSubstr("the terrain is itself a section"));
}

}  // namespace
}  // namespace talus::test
