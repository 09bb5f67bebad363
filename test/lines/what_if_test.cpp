// What if, against runs of the changed projects and closed forms.

#include "talus/lines/what_if.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <string>

#include "lines/read_what_if.hpp"
#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"
#include "talus/core/stop.hpp"
#include "talus/lines/line_answer.hpp"
#include "talus/lines/side_view.hpp"
#include "talus/lines/varied_models.hpp"
#include "talus/lines/what_if_output.hpp"
#include "talus/model/model.hpp"
#include "talus/project/words.hpp"
#include "talus/store/rock_choice.hpp"

namespace talus::what_if {
namespace {

using testing_tools::replaced;
using testing_tools::SimulatedRun;

/// A project with its model, and what is asked of it.
struct Asked {
  project::Project project;
  Problems warnings;  // before the model, which is built with it
  Model model;
  std::unique_ptr<WhatIf> what_if;

  Asked(const project::Project& given, const std::function<AskedPlace(const Model&, Problems&)>& place,
        const FactorChoice& choice = {})
      : project(given), model(project::build_model(project, warnings)) {
    what_if = std::make_unique<WhatIf>(project, model, project::design_basis(project), place(model, warnings), choice,
                                       "--step", warnings);
  }
};

AskedPlace bench(const Model& model, Problems& warnings) {
  constexpr std::array<PlanPlace, 3> line{{{15, 2}, {16, 30}, {14, 58}}};
  return drawn_line(model, line, asked_height, "line", warnings);
}

AskedPlace foot_area(const Model& model, Problems& warnings) {
  constexpr std::array<PlanPlace, 4> corners{{{32, 5}, {45, 5}, {45, 55}, {32, 55}}};
  return drawn_area(model, corners, "polygon", warnings);
}

const FactorChoice only_models{.steps = std::vector<Step>{}, .models = true};

void expect_same(const Figures& one, const Figures& other) {
  EXPECT_EQ(one.rocks, other.rocks);
  EXPECT_EQ(one.percentile, other.percentile);
  EXPECT_EQ(one.demand, other.demand);
  ASSERT_TRUE(one.share && other.share);
  EXPECT_EQ(one.share->value, other.share->value);
  EXPECT_EQ(one.share->low, other.share->low);
  EXPECT_EQ(one.share->high, other.share->high);
}

TEST(WhatIf, HasTheFiguresOfAFinishedRun) {
  for (const char* model : {"lumped_mass", "rigid_sphere"}) {
    const SimulatedRun run(replaced(bouncing_slope, "lumped_mass", model));
    Asked asked(run.project, bench, {.steps = std::vector<Step>{{"roughness", 0.25}}});
    EXPECT_TRUE(asked.what_if->run({}));
    const Answer answer = asked.what_if->answer();
    const AskedLine& line = std::get<AskedLine>(asked.what_if->place());
    const LineAnswer finished =
        ask_lines(run.model, project::design_basis(run.project), run.paths, std::span(&line, 1)).front();
    EXPECT_EQ(answer.rocks, 400u);
    EXPECT_GT(answer.base.rocks, 100u);
    EXPECT_EQ(answer.base.rocks, finished.result.whole.rocks);
    EXPECT_EQ(answer.base.share->low, finished.result.whole.share->low);
    // The usual percentiles, of which the second is the design's.
    const auto& percentiles = finished.result.whole.percentiles;
    const auto of = [&](CrossingQuantity q) {
      const auto place = std::ranges::find(finished.plan.percentiles, finished.plan.design_percentile);
      return percentiles[static_cast<std::size_t>(q)]
                        [static_cast<std::size_t>(place - finished.plan.percentiles.begin())];
    };
    EXPECT_EQ(*answer.base.percentile[0], of(CrossingQuantity::energy_translational));
    EXPECT_EQ(*answer.base.percentile[1], of(CrossingQuantity::energy_total));
    EXPECT_EQ(*answer.base.percentile[2], of(CrossingQuantity::height));
    EXPECT_EQ(*answer.base.percentile[3], of(CrossingQuantity::velocity));
    // The same design: its factors make the fence higher and stronger than the percentiles.
    EXPECT_EQ(asked.what_if->standard(), finished.plan.standard);
    ASSERT_TRUE(answer.base.demand);
    EXPECT_EQ(answer.base.demand, finished.result.whole.demand);
    EXPECT_EQ(answer.base.demand_at_upper_end, finished.result.whole.demand_at_upper_end);
    EXPECT_GT(answer.base.demand->maximum_energy, answer.base.percentile[0]->value);
    EXPECT_NE(answer.variations[1].figures.demand, answer.base.demand);
  }
}

TEST(WhatIf, HasTheFiguresOfAPolygon) {
  const SimulatedRun run(bouncing_slope);
  Asked asked(run.project, foot_area, {.steps = std::vector<Step>{{"roughness", 0.25}}});
  EXPECT_TRUE(asked.what_if->run({}));
  const AreaAnswer finished =
      ask_area(run.model, project::design_basis(run.project), run.paths, std::get<AskedArea>(asked.what_if->place()));
  EXPECT_GT(finished.entering.size(), 50u);
  EXPECT_EQ(asked.what_if->answer(0).base.rocks, finished.entering.size());
  EXPECT_FALSE(asked.what_if->answer(0).base.demand) << "a fence stands at a line";
}

/// A variation is a run of the changed project.
TEST(WhatIf, HasTheFiguresOfEachChangedProject) {
  const std::string text =
      replaced(bouncing_slope, "dynamic_friction", "forest = \"open\"\nforest_height_m = 3\ndynamic_friction");
  for (const char* model : {"lumped_mass", "rigid_sphere"}) {
    Asked asked(read(replaced(text, "lumped_mass", model)), bench);
    EXPECT_TRUE(asked.what_if->run({}));
    const Answer answer = asked.what_if->answer(0);
    ASSERT_GE(answer.variations.size(), 10u);
    for (std::size_t k = 0; k < answer.variations.size(); ++k) {
      const Variation& variation = asked.what_if->variations()[k];
      SCOPED_TRACE(std::string(factor_kinds[variation.kind].key) + step_text(variation));
      Asked changed(variation.project, bench, {.steps = std::vector<Step>{{"mass", 0.1}}});
      EXPECT_TRUE(changed.what_if->run({}));
      expect_same(answer.variations[k].figures, changed.what_if->answer(0).base);
    }
  }
}

/// A rock model is a run of the project with that model, from any other.
TEST(WhatIf, HasTheFiguresOfEachRockModel) {
  for (const char* model : {"lumped_mass", "rigid_sphere", "rigid_body"}) {
    SCOPED_TRACE(model);
    Asked asked(read(replaced(bouncing_slope, "lumped_mass", model)), bench, only_models);
    EXPECT_TRUE(asked.what_if->run({}));
    const Answer answer = asked.what_if->answer(0);
    ASSERT_EQ(answer.variations.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      const Variation& variation = asked.what_if->variations()[k];
      ASSERT_TRUE(variation.model);
      SCOPED_TRACE(step_text(variation));
      EXPECT_EQ(variation.project.analysis.model, *variation.model);
      Asked other(variation.project, bench, only_models);
      EXPECT_TRUE(other.what_if->run({}));
      const Figures& by_run = other.what_if->answer(0).base;
      expect_same(answer.variations[k].figures, by_run);
      EXPECT_EQ(answer.variations[k].figures.runout, by_run.runout);
      const auto json = json_of(*asked.what_if, answer);
      const nlohmann::ordered_json disagreement{{"model", project::word(*variation.model)}, {"figure", "runout_m"}};
      const auto& all = json.at("models_disagree");
      EXPECT_EQ(std::ranges::count(all, disagreement), are_apart(*answer.base.runout, *by_run.runout) ? 1 : 0);
    }
  }
}

/// Blocks of a project without shapes are those that were measured; a shape that it has stays.
TEST(WhatIf, GivesBlocksAShape) {
  const auto shape_of = [](const std::string& text) {
    Problems warnings;
    const auto others = variations_of(read(text), only_models, "--models", warnings);
    return others.back().project.seeders.front().shape;
  };
  EXPECT_EQ(shape_of(bouncing_slope), "block");
  EXPECT_EQ(shape_of(replaced(bouncing_slope, "rocks = 400", "rocks = 400\nshape = \"cube\"")), "cube");
}

TEST(WhatIf, NamesTheShapesOfAModel) {
  Asked asked(read(replaced(bouncing_slope, "rocks = 400", "rocks = 4\nshape = \"cube\"")), bench, only_models);
  EXPECT_TRUE(asked.what_if->run({}));
  const auto variations = json_of(*asked.what_if, asked.what_if->answer(1)).at("variations");
  ASSERT_EQ(variations.size(), 2u);
  EXPECT_EQ(variations[0].at("model"), "rigid_sphere");
  EXPECT_TRUE(variations[0].at("shapes").empty());
  EXPECT_EQ(variations[1].at("shapes"), nlohmann::json::array({"cube"}));
}

TEST(WhatIf, SaysWhichFrictionNobodyHasChosen) {
  const auto said = [](const std::string& text) {
    Problems warnings;
    (void)variations_of(read(text), only_models, "--models", warnings);
    std::vector<std::string> what;
    for (const Problem& problem : warnings.list()) what.push_back(problem.what);
    return what;
  };
  using Said = std::vector<std::string>;
  EXPECT_EQ(said(bouncing_slope), Said{"as rigid body, Rock has the default friction"});
  EXPECT_EQ(said(replaced(bouncing_slope, "rolling_friction = 0.35", "")),
            Said{"as rigid sphere and rigid body, Rock has the default friction"});
  const std::string bare = replaced(bouncing_slope, "friction_angle_deg = 34", "");
  EXPECT_EQ(said(replaced(bare, "dynamic_friction = 0.5", "dynamic_friction = 0.6")),
            Said{"Rock has the default friction"});
}

/// The runout of all rocks is that of a run, whether they cross or not.
TEST(WhatIf, TellsHowFarRocksGoWithoutAPlace) {
  const auto nowhere = [](const Model&, Problems&) -> AskedPlace { return std::monostate{}; };
  const SimulatedRun run(bouncing_slope);
  Asked asked(run.project, nowhere, only_models);
  EXPECT_TRUE(asked.what_if->run({.pictured = 10}));
  const Figures base = asked.what_if->answer(0).base;
  EXPECT_EQ(base.rocks, 0u);
  EXPECT_FALSE(base.share);
  std::vector<double> runouts;
  std::uint64_t left = 0;
  Simulator simulator(run.model, *run.model.surface);
  for (std::uint64_t rock = 0; rock < run.model.rocks(); ++rock) {
    const RockOutcome outcome = simulator.simulate(rock, false).outcome;
    runouts.push_back((outcome.end.position - outcome.start.position).xy().norm());
    left += outcome.reason == EndReason::left_model ? 1 : 0;
  }
  std::ranges::sort(runouts);
  EXPECT_GE(base.runout_median->value, runouts[runouts.size() / 2 - 1]);
  EXPECT_LE(base.runout_median->value, runouts[runouts.size() / 2]);
  EXPECT_EQ(base.left->value, static_cast<double>(left) / static_cast<double>(run.model.rocks()));
  // Ten paths of each model are drawn, each from the release of the rock to where it ended.
  const auto view = side_view(*asked.what_if);
  ASSERT_EQ(view["sets"].size(), 3u);
  for (const auto& set : view["sets"]) ASSERT_EQ(set["paths"].size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) {
    const double start = view["sets"][0]["paths"][k].front()[1].get<double>();
    EXPECT_NEAR(view["sets"][1]["paths"][k].front()[1].get<double>(), start, 2.0);  // centres of spheres are higher
  }
  EXPECT_GT(view["ground"].size(), 2u);
}

/// Common random numbers: a rock starts at the same place with the same velocity in all sets.
TEST(WhatIf, StartsEachRockInTheSameWay) {
  Asked asked(read(bouncing_slope), bench);
  const auto& variations = asked.what_if->variations();
  const auto models = varied_models(asked.project, asked.model, variations, "");
  ASSERT_EQ(models.size(), variations.size() + 1);
  for (std::uint64_t rock = 0; rock < 40; ++rock) {
    Simulator base(models[0], *asked.model.surface);
    const RockRecord own = base.simulate(rock, false);
    for (std::size_t k = 0; k < variations.size(); ++k) {
      Simulator varied(models[k + 1], *asked.model.surface);
      const RockRecord record = varied.simulate(rock, false);
      EXPECT_EQ(record.outcome.start.position, own.outcome.start.position);
      EXPECT_EQ(record.outcome.start.velocity, own.outcome.start.velocity);
      const bool is_mass = factor_kinds[variations[k].kind].key == "mass";
      EXPECT_NEAR(record.body.mass, own.body.mass * (is_mass ? variations[k].factor : 1), 1e-6 * own.body.mass);
    }
  }
}

/// Rocks slide on a plane after a drop of a centimetre, in which they keep the part Rt of their velocity: they stop
/// after v t + (Rt v)^2 / (2 g tan(phi)) with the time t of the fall. Velocities are uniform between 8 and 16 m/s, one
/// in each of 2000 equal classes, so that shares are exact to a class or two.
TEST(WhatIf, AgreesWithSlidingOnAPlane) {
  const std::string plane = R"([analysis]
model = "lumped_mass"
rotation = false
sliding = "closed_form"
gravity_m_s2 = 9.81
[sampling]
method = "latin_hypercube"
[terrain]
section = [[0, 0], [200, 0]]
[[material]]
name = "Flat"
normal_restitution = 0
tangential_restitution = 0.8
friction_angle_deg = 25
[[seeder]]
position = [1, 0.01]
mass_kg = 100
rocks = 2000
horizontal_velocity_m_s = { mean = 12, distribution = "uniform", rel_min = 4, rel_max = 4 }
)";
  constexpr double line = 12;
  const auto place = [&](const Model& model, Problems& warnings) -> AskedPlace {
    const PlanPlace at{1 + line, 0};
    return drawn_line(model, std::span(&at, 1), asked_height, "line", warnings);
  };
  Asked asked(read(plane), place,
              {.steps = std::vector<Step>{{"tangential_restitution", 0.1}, {"friction_angle", 0.1}}});
  EXPECT_TRUE(asked.what_if->run({}));
  const Answer answer = asked.what_if->answer(0);
  const auto expected = [&](double restitution, double angle_deg) {
    const double g = 9.81, fall = std::sqrt(2 * 0.01 / g), friction = std::tan(angle_deg * std::numbers::pi / 180);
    double low = 8, high = 16;
    for (int step = 0; step < 60; ++step) {
      const double v = (low + high) / 2, way = v * fall + std::pow(restitution * v, 2) / (2 * g * friction);
      (way < line ? low : high) = v;
    }
    return (16 - low) / 8;
  };
  constexpr double classes = 2.5 / 2000;
  EXPECT_NEAR(answer.base.share->value, expected(0.8, 25), classes);
  const double shares[] = {expected(0.72, 25), expected(0.88, 25), expected(0.8, 22.5), expected(0.8, 27.5)};
  ASSERT_EQ(answer.variations.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [figures, differences] = answer.variations[k];
    EXPECT_NEAR(figures.share->value, shares[k], classes);
    EXPECT_NEAR(differences.share->value, shares[k] - expected(0.8, 25), 2 * classes);
    EXPECT_GT(std::abs(differences.share->value), 0.05) << "a step matters here";
    // Faster rocks cross first: with the same rocks none is gained where others are lost.
    EXPECT_EQ(std::min(differences.gained, differences.lost), 0u);
    // The interval of the difference is narrower than the two shares' own.
    const double own = figures.share->high - figures.share->low;
    EXPECT_LT(*differences.share->high - *differences.share->low, own);
  }
}

TEST(WhatIf, IsTheSameOnAnyNumberOfThreads) {
  const auto table = [&](int threads) {
    Asked asked(read(bouncing_slope), bench);
    EXPECT_TRUE(asked.what_if->run({.threads = threads}));
    return table_of(*asked.what_if, asked.what_if->answer(100));
  };
  const std::string one = table(1);
  EXPECT_EQ(one, table(2));
  EXPECT_EQ(one.substr(0, one.find(',')), "factor");
}

/// Fewer rocks are a sample of all, taken in the order of a store.
TEST(WhatIf, TakesAFairSample) {
  Asked asked(read(bouncing_slope), bench, {.steps = std::vector<Step>{{"roughness", 0.25}}});
  EXPECT_TRUE(asked.what_if->run({.rocks = 100}));
  const Answer answer = asked.what_if->answer(0);
  EXPECT_EQ(answer.rocks, 100u);
  EXPECT_EQ(answer.planned, 400u);
  // Half of the rocks of a project are in its store if it has room for half: those rocks give the same share.
  SimulatedRun run(bouncing_slope);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> order;
  for (std::uint64_t rock = 0; rock < 400; ++rock) order.emplace_back(place_in_choice(run.model.seed, rock), rock);
  std::ranges::sort(order);
  std::set<std::uint64_t> first;
  for (std::size_t k = 0; k < 100; ++k) first.insert(order[k].second);
  run.paths.keep(400, [&](std::uint64_t rock) { return first.contains(rock); });
  const AskedLine& line = std::get<AskedLine>(asked.what_if->place());
  EXPECT_EQ(
      ask_lines(run.model, project::design_basis(run.project), run.paths, std::span(&line, 1)).front().crossings.size(),
      answer.base.rocks);
}

TEST(WhatIf, KeepsWhatIsDoneWhenItIsStopped) {
  Asked asked(read(replaced(bouncing_slope, "rocks = 400", "rocks = 5000")), bench);
  std::atomic<bool> stop{false};
  std::uint64_t reported = 0;
  const StopScope scope(&stop);
  EXPECT_FALSE(asked.what_if->run({.progress = [&](std::uint64_t done, std::uint64_t) {
    reported = done;
    stop = true;
  }}));
  EXPECT_GT(reported, 0u);
  EXPECT_LT(reported, 5000u);
  stop = false;
  const Answer answer = asked.what_if->answer(0);
  EXPECT_EQ(answer.rocks, reported);
  EXPECT_EQ(answer.base.share->of, reported);
}

TEST(WhatIf, EndsInTime) {
  Asked asked(read(replaced(bouncing_slope, "rocks = 400", "rocks = 5000000")), bench);
  EXPECT_TRUE(asked.what_if->run({.rocks = 100'000, .seconds = 0.2}));
  EXPECT_GE(asked.what_if->answer(0).rocks, 16u);
  EXPECT_LT(asked.what_if->answer(0).rocks, 100'000u);
}

/// Ensembles of uncertain parameters move from their own values.
TEST(WhatIf, VariesEachEnsembleFromItsOwnValues) {
  const Asked asked(read(bouncing_slope), bench);
  Model model = asked.model.without_surface();
  model.uncertain = {"material.Rock.tangential_restitution"};
  for (const double value : {0.6, 0.8}) {
    project::Project drawn = asked.project;
    drawn.materials[0].tangential_restitution.mean = value;
    model.ensembles.push_back(asked.model.without_surface());
    project::set_properties(drawn, model.ensembles.back());
    model.drawn_parameters.push_back({value});
  }
  const std::vector<Variation> up{vary(asked.project, 1, 1.1, "")};
  const auto models = varied_models(asked.project, model, up, "");
  ASSERT_EQ(models.size(), 2u);
  ASSERT_EQ(models[1].ensembles.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto median = [&](const Model& of) { return of.ground.materials().front().tangential_restitution.draw(0.5); };
    EXPECT_NEAR(median(models[1].ensembles[k]), 1.1 * median(models[0].ensembles[k]), 1e-9);
  }
}

}  // namespace
}  // namespace talus::what_if
