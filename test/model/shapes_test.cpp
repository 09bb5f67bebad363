// Projects with shapes of rocks: their models, their rocks, and the exact text of what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/input_folder.hpp"
#include "support/places.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using ::testing::HasSubstr;

/// A slope of 100 m at 34 degrees that runs out on level ground.
const std::string slope_of_bodies = R"([analysis]
model = "rigid_body"
[terrain]
section = [[0, 100], [150, 0], [600, 0]]
)";
const std::string ground_of_bodies = R"([[material]]
name = "Scree"
normal_restitution = 0.35
dynamic_friction = 0.5
rolling_friction = 0.05
)";

class ShapesOfRocks : public testing_tools::InputFolder {
 protected:
  [[nodiscard]] static std::string in_2d(const std::string& rest) { return slope_of_bodies + ground_of_bodies + rest; }
  [[nodiscard]] static std::string in_3d(const std::string& rest) {
    return slope_of_bodies + "width_m = 100\n" + ground_of_bodies + rest;
  }
  [[nodiscard]] static std::string seeder(const std::string& keys, bool is_2d = false) {
    return std::string("[[seeder]]\nposition = ") + (is_2d ? "[1]" : "[1, 50]") +
           "\nheight_above_m = 2\nmass_kg = 1000\n" + keys;
  }
  [[nodiscard]] Model model(const std::string& text) {
    write("slope.toml", text);
    Reading reading = read_project(path("slope.toml"));
    warnings_ = reading.warnings;
    project_ = reading.project;
    return build_model(reading.project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& text) {
    return refusal_of([&] { static_cast<void>(model(text)); });
  }

  Project project_;
};

struct Runouts {
  double mean = 0, error = 0, aside = 0;  // aside: standard deviation of y [m]
};

Runouts runouts_of(const Model& model, std::uint64_t rocks) {
  Simulator simulator(model);
  double sum = 0, squares = 0, aside = 0;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    const RockOutcome outcome = simulator.simulate(rock, false).outcome;
    const double x = outcome.end.position.x(), y = outcome.end.position.y() - outcome.start.position.y();
    sum += x;
    squares += x * x;
    aside += y * y;
  }
  const auto n = static_cast<double>(rocks);
  return {sum / n, std::sqrt((squares / n - sum * sum / n / n) / n), std::sqrt(aside / n)};
}

// The order that is found in the field, by b/a; and flat blocks run on edge, as wheels do, in any direction.
TEST_F(ShapesOfRocks, LongBlocksStopFirstAndSpheresLast) {
  constexpr std::uint64_t rocks = 200;
  const auto runouts = [&](const std::string& shape) {
    std::string text = in_3d("roughness_deg = 10\n" + seeder("rocks = 200\nshape = \"" + shape + "\"\n"));
    text.replace(text.find("width_m = 100"), 13, "width_m = 800");
    text.replace(text.find("[1, 50]"), 7, "[1, 400]");
    return runouts_of(model(text), rocks);
  };
  const Runouts far = runouts("long"), farther = runouts("equant"), farthest = runouts("sphere"),
                flat = runouts("flat");
  EXPECT_GT(farther.mean - far.mean, 4 * std::hypot(far.error, farther.error));
  EXPECT_GT(farthest.mean - farther.mean, 4 * std::hypot(farther.error, farthest.error));
  EXPECT_GT(flat.mean - far.mean, 2 * std::hypot(flat.error, far.error));
  EXPECT_GT(flat.aside, 1.5 * farther.aside);
}

TEST_F(ShapesOfRocks, EveryWordMakesABody) {
  for (const BuiltInShape& each : built_in_shapes()) {
    const Model built = model(in_3d(seeder("shape = \"" + each.shape.name + "\"\n")));
    EXPECT_EQ(warnings(), "");
    const RockShapes& shapes = *built.seeders.front().shapes;
    ASSERT_EQ(shapes.kinds.size(), 1U) << each.shape.name;
    Simulator simulator(built);
    EXPECT_NE(simulator.simulate(0, false).outcome.reason, EndReason::lost) << each.shape.name;
    if (!each.is_for_sections) continue;
    const Model section = model(in_2d(seeder("shape = \"" + each.shape.name + "\"\n", true)));
    for (const RockShape& hull : section.seeders.front().shapes->kinds.front().hulls) {
      for (const Vec3& corner : hull.corners) EXPECT_EQ(corner.y(), 0);
    }
  }
}

TEST(BuiltInShapes, AreAllInThePageOfShapes) {
  std::ifstream page(places::in_source("/docs/shapes.md"));
  const std::string text(std::istreambuf_iterator<char>(page), {});
  for (const BuiltInShape& each : built_in_shapes())
    EXPECT_THAT(text, HasSubstr("`" + each.shape.name + "`")) << "which says what each word means";
}

// A square prism, and its section: the same impacts until rounding has grown.
TEST_F(ShapesOfRocks, ASectionMovesAsItsPrismOnAnExtrudedSlope) {
  for (const char* shape : {"square", "hexagon", "rectangle_1_2"}) {
    const std::string keys = "orientation_deg = {}\nshape = \"" + std::string(shape) + "\"\n";
    const auto with = [&](const char* turn) { return std::string(keys).replace(keys.find("{}"), 2, turn); };
    const Model flat = model(in_2d(seeder(with("[20]"), true)));
    const Model deep = model(in_3d(seeder(with("[0, 20, 0]"))));
    Simulator in_section(flat), in_space(deep);
    static_cast<void>(in_section.simulate(0, true));
    static_cast<void>(in_space.simulate(0, true));
    const auto &one = in_section.log().rows, &other = in_space.log().rows;
    for (std::size_t k = 0; k < 7; ++k) {
      ASSERT_LT(k, std::min(one.size(), other.size()));
      const Motion &a = one[k].motion, &b = other[k].motion;
      EXPECT_NEAR(a.time, b.time, 1e-5) << shape << k;
      EXPECT_NEAR(a.position.x(), b.position.x(), 1e-4) << shape << k;
      EXPECT_NEAR(a.position.z() + flat.frame.origin.z(), b.position.z() + deep.frame.origin.z(), 1e-4) << shape << k;
      EXPECT_NEAR(a.velocity.x(), b.velocity.x(), 1e-4) << shape << k;
      EXPECT_EQ(a.velocity.y(), 0) << shape << k;
    }
  }
}

TEST_F(ShapesOfRocks, RatiosOfASectionAreDrawn) {
  const Model built =
      model(in_2d("[[shape]]\nname = \"Slabs\"\nb_over_a = { mean = 0.5, distribution = \"uniform\", rel_min = 0.2, "
                  "rel_max = 0.2 }\n" +
                  seeder("shape = \"Slabs\"\nrocks = 500\n", true)));
  const talus::Seeder& slabs = built.seeders.front();
  double least = 1, most = 0;
  for (std::uint64_t rock = 0; rock < slabs.rocks; ++rock) {
    RockShape own;
    const RockShape* const shape =
        slabs.shapes->draw(Draws({built.seed, built.sampling, 0, slabs.rocks}, rock), {}, own);
    Vec3 high;
    for (const Vec3& corner : shape->corners) high = high.max(corner);
    least = std::min(least, high.z() / high.x());
    most = std::max(most, high.z() / high.x());
  }
  EXPECT_NEAR(least, 0.3, 0.02);
  EXPECT_NEAR(most, 0.7, 0.02);
}

TEST_F(ShapesOfRocks, AScanIsItsHullAtTheVolumeOfTheRock) {
  write("block.obj",
        "v 0 0 0\nv 200 0 0\nv 200 100 0\nv 0 100 0\nv 0 0 50\nv 200 0 50\nv 200 100 50\nv 0 100 50\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Model built = model(in_3d("[[shape]]\nname = \"Scan\"\nscan = \"block.obj\"\n" + seeder("shape = \"Scan\"\n")));
  EXPECT_EQ(built.seeder_report,
            "shape \"Scan\": 8 points of \"block.obj\"; hull of 1e+06 in the cube of their unit, convexity 1.00; axes "
            "200, 100, 50 (b/a 0.50, c/b 0.50) along its principal axes of inertia; 8 corners kept, 100 % of the hull; "
            "moments of inertia 0.1042, 0.3542, 0.4167 m2 for 1 kg and 1 m3");
  const RockShape& shape = built.seeders.front().shapes->kinds.front().hulls.front();
  EXPECT_NEAR(shape.gyration[0], (1 + 0.25) / 12, 1e-12);  // a box of 2 x 1 x 0.5 m
  EXPECT_EQ(warnings(), "");
}

TEST_F(ShapesOfRocks, BadScansAreRefusedOrWarnedOf) {
  const auto with = [&](const char* file, const std::string& bytes) {
    write(file, bytes);
    return in_3d("[[shape]]\nname = \"Scan\"\nscan = \"" + std::string(file) + "\"\n" + seeder("shape = \"Scan\"\n"));
  };
  EXPECT_EQ(refusal(with("flat.xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n")),
            "flat.xyz: shape \"Scan\": its points lie in a plane (a hull has a volume)");
  EXPECT_EQ(refusal(with("few.xyz", "0 0 0\n1 0 0\n")),
            "few.xyz: shape \"Scan\": it has 2 points (a hull has four or more)");
  EXPECT_THAT(refusal(with("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), HasSubstr("nan.obj"));
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  static_cast<void>(model(with("open.obj", tetrahedron)));
  EXPECT_THAT(warnings(), HasSubstr("open.obj: warning: is not closed: 3 of its edges have no second triangle"));
  static_cast<void>(
      model(with("inside_out.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n")));
  EXPECT_THAT(warnings(), HasSubstr("inside_out.obj: warning: is inside out"));
  // A tetrahedron whose large face is drawn in to near the opposite corner.
  EXPECT_THAT(refusal(with("hollow.obj",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.1 0.1 0.1\n"
                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\n")),
              HasSubstr("fills 0.3 of its convex hull"));
}

TEST_F(ShapesOfRocks, ATableGivesTheAxesOfEachBlock) {
  write("blocks.csv", "x_m,y_m,mass_kg,a_m,b_m,c_m\n1,50,900,1.2,0.6,0.6\n1,50,900,0.6,0.9,0.9\n");
  const std::string table = "[[seeder]]\ntype = \"table\"\ntable = \"blocks.csv\"\nheight_above_m = 2\n";
  const Model built = model(in_3d(table));
  EXPECT_THAT(built.seeder_report, HasSubstr("columns x_m, y_m, mass_kg, a_m, b_m, c_m"));
  const auto& rows = std::get<ReleaseTable>(*built.seeders.front().where);
  EXPECT_EQ(rows.given(1).axes, Vec3(0.9, 0.9, 0.6)) << "in descending order";
  std::string of_spheres = in_3d(table);
  of_spheres.replace(of_spheres.find("rigid_body"), 10, "rigid_sphere");
  EXPECT_THAT(model(of_spheres).seeder_report, HasSubstr("(not used: a_m, b_m, c_m)"));
  EXPECT_EQ(
      refusal(in_3d(table + "shape = \"cube\"\n")),
      "slope.toml:11: seeder \"seeder 1\": shape is \"cube\", and its table gives the axes of blocks (only a block "
      "can have any axes). Use a shape with b_over_a and c_over_b, or rename a_m, b_m, c_m");
  write("blocks.csv", "x_m,y_m,mass_kg,a_m,b_m,c_m\n1,50,900,1.2,0.6,\n1,50,900,,,\n1,50,900,1,1,0.01\n");
  EXPECT_EQ(refusal(in_3d(table)),
            "slope.toml:13: seeder 1: table blocks.csv:2: the row gives only some axes (a block has three: a_m, b_m "
            "and c_m)\n"
            "slope.toml:13: seeder 1: table blocks.csv:3: the row gives no axes (other rows may have them, and the "
            "seeder names no "
            "shape). Give it a shape\n"
            "slope.toml:13: seeder 1: table blocks.csv:4: its shortest axis is 0.01 of the longest (expected at least "
            "0.05). Compare "
            "their units");
}

struct RefusedShape {
  const char* name;
  const char* text;     // of the shape, from line 11 (2D: 10) on
  const char* problem;  // without "slope.toml:"
  bool is_2d = false;
};

class RefusedShapes : public ShapesOfRocks, public ::testing::WithParamInterface<RefusedShape> {};

TEST_P(RefusedShapes, HaveTheseProblems) {
  const RefusedShape& c = GetParam();
  const std::string text = std::string(c.text) + seeder("shape = \"sphere\"\n", c.is_2d);
  EXPECT_EQ(refusal(c.is_2d ? in_2d(text) : in_3d(text)), "slope.toml:" + std::string(c.problem));
}

const std::vector<RefusedShape> refused_shapes{
    {"NoForm", "[[shape]]\nname = \"A\"\n",
     "11: shape \"A\": the form is missing (expected one of b_over_a with c_over_b, axes_m, solid, sides, polygon, "
     "scan "
     "and of)"},
    {"TwoForms", "[[shape]]\nname = \"A\"\nsides = 5\nsolid = \"cube\"\n",
     "13: shape \"A\": solid and sides are given together (they exclude each other)"},
    {"TakenWord", "[[shape]]\nname = \"cube\"\nsides = 5\n",
     "12: shape \"cube\": name is \"cube\" (that word has a meaning of its own). Choose another name"},
    {"ThirdAxis", "[[shape]]\nname = \"A\"\nb_over_a = 0.5\n",
     "11: shape \"A\": c_over_b is missing (a block has three axes). Give the shortest axis over the intermediate one; "
     "1 "
     "if they are equal"},
    {"TwoAxes", "[[shape]]\nname = \"A\"\naxes_m = [1, 2]\n", "13: shape \"A\": axes_m has 2 numbers (expected three)"},
    {"ANeedle", "[[shape]]\nname = \"A\"\naxes_m = [0.01, 2, 1]\n",
     "13: shape \"A\": the shortest axis is 0.005 of the longest (expected at least 0.05). Compare their units"},
    {"UnknownOfGroup", "[[shape]]\nname = \"A\"\nof = [\"cub\"]\n",
     "13: shape \"A\": of[0] is \"cub\" (no shape has this name). Did you mean \"cube\"?"},
    {"NestedGroup", "[[shape]]\nname = \"A\"\nof = [\"A\"]\n",
     "13: shape \"A\": of[0] is \"A\" (it is a group itself). Name its shapes"},
    {"SharesOfOthers", "[[shape]]\nname = \"A\"\nof = [\"cube\"]\nshares = [1, 2]\n",
     "14: shape \"A\": shares has 2 numbers (of has 1 shapes)"},
    {"NoSuchScan", "[[shape]]\nname = \"A\"\nscan = \"none.obj\"\n",
     "13: shape \"A\": scan is \"none.obj\" (there is no such file). The path is relative to the project file"},
    {"SolidIn2D", "[[shape]]\nname = \"A\"\nsolid = \"cube\"\n",
     "12: shape \"A\": solid is given in 2D (rocks in a section have a section as shape). Use sides, polygon, axes_m "
     "or "
     "b_over_a",
     true},
    {"PolygonWithoutArea", "[[shape]]\nname = \"A\"\npolygon = [[0, 0], [1, 1], [2, 2]]\n",
     "12: shape \"A\": polygon crosses or touches itself (at or near (0, 0)). Give its corners in order, once around",
     true},
};

INSTANTIATE_TEST_SUITE_P(Shapes, RefusedShapes, ::testing::ValuesIn(refused_shapes),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_F(ShapesOfRocks, AreRefusedWhereASeederCannotUseThem) {
  EXPECT_EQ(refusal(in_2d(seeder("shape = \"flat\"\n", true))),
            "slope.toml:14: seeder 1: shape is \"flat\" (it is a solid, and a section has no room for one). Use "
            "a section: \"square\", \"hexagon\" or a [[shape]] with polygon, sides or b_over_a");
  EXPECT_THAT(refusal(in_3d(seeder("shape = \"equnt\"\n"))), HasSubstr("Did you mean \"equant\"?"));
  EXPECT_THAT(refusal(in_3d(seeder("shape = \"cube\"\norientation_deg = [1]\n"))),
              HasSubstr("orientation_deg has 1 numbers (expected three: about z, about y, about x)"));
}

TEST_F(ShapesOfRocks, HaveNoEffectOnPointsAndSpheresAndAreSaidToHaveNone) {
  std::string text = in_3d(seeder("shape = \"cube\"\n"));
  text.replace(text.find("rigid_body"), 10, "rigid_sphere");
  const Model built = model(text);
  EXPECT_TRUE(built.seeders.front().shapes->kinds.empty());
  EXPECT_THAT(warnings(), HasSubstr("shape has no effect (it needs model = \"rigid_body\")"));
  static_cast<void>(model(in_3d(seeder(""))));
  EXPECT_THAT(warnings(), HasSubstr("no seeder has a shape"));
}

TEST_F(ShapesOfRocks, WarnOfRestitutionThatCouldCreateEnergy) {
  std::string text = in_3d(seeder("shape = \"cube\"\n"));
  text.replace(text.find("0.35"), 4, "0.80");
  static_cast<void>(model(text));
  EXPECT_THAT(warnings(), HasSubstr("normal_restitution is 0.8 (above 0.67 an impact of a block with friction could "
                                    "create energy"));
}

TEST_F(ShapesOfRocks, AnotherScanIsAnotherModel) {
  const std::string text = in_3d("[[shape]]\nname = \"S\"\nscan = \"a.xyz\"\n" + seeder("shape = \"S\"\n"));
  std::vector<std::string> prints;
  for (const char* z : {"1", "1.5"}) {
    write("a.xyz", std::string("0 0 0\n1 0 0\n0 1 0\n0 0 ") + z + "\n");
    const Model built = model(text);
    prints.push_back(fingerprint_of(echo(project_), built));
  }
  EXPECT_NE(prints[0], prints[1]);
}

}  // namespace
}  // namespace talus::project
