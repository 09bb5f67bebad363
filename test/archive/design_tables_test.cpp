// The exact text of design.csv, design_ranking.csv and the key of summary.json; the plan as JSON.

#include "talus/archive/design_tables.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "cli/program.hpp"
#include "talus/archive/design_json.hpp"
#include "talus/core/bytes.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

DesignPlan small_plan() {
  DesignPlan plan;
  plan.lines = {{"Road, lower", 1, 15.5, 10, 2}, {"Rim", 0, 12, 20, 1, 0.5, {{0.5, 1, 0}}, {6}}};
  plan.protect = 0;
  plan.percentiles = {97.5};
  plan.standard = "UNI 11211-4";
  plan.standard_not_read = "The text";
  plan.applied = {{"γ_R", "risk_factor", "energy", "Users of it", "Its classes", 1.1}};
  plan.factors.energy = 1.1;
  plan.factors.block_mass = 1500;
  plan.heights = {1.5, 3};
  plan.energies = {450e3, 500e3};
  plan.kits = {{"Net", {3}, 500e3, 450e3, 4.0, 0.5, 900.0}};
  plan.pairs = {{0, 1, 3.0, 15.0}};
  plan.free_end = 2.5;
  return plan;
}

DesignResult small_result() {
  DesignFigures first{.from = 0, .to = 10, .rocks = 3, .share = RockShare{3, 12, 0.25, 0.125, 0.5}};
  first.percentiles = {
      {{Estimate{1000, 500, {}}}, {Estimate{1100, 550, {}}}, {Estimate{10, 5, {}}}, {Estimate{2, 1.5, {}}}}};
  first.demand = KitDemand{1200, 0, 2.5};
  DesignFigures second{.from = 10, .to = 15.5, .share = RockShare{0, 12, 0, 0, 0.25}};
  DesignResult result;
  DesignFigures whole = first;
  whole.to = 15.5;
  whole.demand_at_upper_end = KitDemand{260e3, 2, 4};
  whole.lateral = 0.25;
  whole.largest_block = 1.25;
  whole.clearance = 6;
  whole.most_elongation = 5;
  const DesignFigures rim{.from = 0.5, .to = 12.5};
  result.lines = {{whole, {first, second}}, {rim, {rim}}};
  result.pairs = {{.pair = 0,
                   .first = {1, 0, 3, 500e3},
                   .second = {0, 0, 3, 500e3},
                   .caught = RockShare{3, 4, 0.75, 0.25, 1},
                   .by_first = 2,
                   .at_second = 1,
                   .by_second = 1,
                   .suffices = true,
                   .cost = 2000,
                   .needed_overlap = 4.5}};
  result.ranking = {{.line = 0,
                     .kit = 0,
                     .height = 3,
                     .maximum_energy = 500e3,
                     .kit_class = 2,
                     .suffices = true,
                     .is_sure = false,
                     .caught = RockShare{3, 4, 0.75, 0.25, 1},
                     .above = 1,
                     .through = 0,
                     .beside = 0,
                     .cost = 1039.5,
                     .needed_clearance = 5.5,
                     .clearance = 6,
                     .residual_height = 1.5,
                     .below_residual = RockShare{2, 4, 0.5, 0.1, 0.9}}};
  return result;
}

TEST(DesignTables, HaveTheExpectedText) {
  EXPECT_EQ(
      design_table(small_plan(), small_result()),
      "line,section,from_m,to_m,rocks,share,share_low,share_high,"
      "ke_translational_p97.5_J,ke_translational_p97.5_low_J,ke_translational_p97.5_high_J,"
      "ke_total_p97.5_J,ke_total_p97.5_low_J,ke_total_p97.5_high_J,"
      "velocity_p97.5_m_s,velocity_p97.5_low_m_s,velocity_p97.5_high_m_s,"
      "height_p97.5_m,height_p97.5_low_m,height_p97.5_high_m,"
      "needs_mel_kJ,needs_class,needs_height_m,needs_high_mel_kJ,needs_high_class,needs_high_height_m,"
      "lateral,clearance_m,most_elongation_m,largest_block_m\n"
      "\"Road, lower\",all,0,15.5,3,0.25,0.125,0.5,1000,500,,1100,550,,10,5,,2,1.5,,1.2,0,2.5,260,2,4,0.25,6,5,1.25\n"
      "\"Road, lower\",1,0,10,3,0.25,0.125,0.5,1000,500,,1100,550,,10,5,,2,1.5,,1.2,0,2.5,,,,,,,\n"
      "\"Road, lower\",2,10,15.5,0,0,0,0.25,,,,,,,,,,,,,,,,,,,,,,\n"
      "Rim,all,0.5,12.5,0,,,,,,,,,,,,,,,,,,,,,,,,,\n"
      "Rim,1,0.5,12.5,0,,,,,,,,,,,,,,,,,,,,,,,,,\n");
  EXPECT_EQ(ranking_table(small_plan(), small_result()),
            "rank,line,length_m,height_m,mel_kJ,class,suffices,sure,cost,rocks,caught,caught_share,caught_share_low,"
            "caught_share_high,above,through,beside,limit,kit,needs_clearance_m,clearance_m,residual_height_m,"
            "below_residual_share\n"
            "1,\"Road, lower\",15.5,3,500,2,yes,no,1039.5,4,3,0.75,0.25,1,1,0,0,,Net,5.5,6,1.5,0.5\n");
  EXPECT_EQ(pair_table(small_plan(), small_result()),
            "rank,first,first_kit,first_height_m,first_mel_kJ,second,second_kit,second_height_m,second_mel_kJ,suffices,"
            "sure,cost,rocks,caught,caught_share,caught_share_low,caught_share_high,caught_by_first,at_second,"
            "caught_by_second,beside,overlap_m,distance_m,needs_overlap_m\n"
            "1,Rim,Net,3,500,\"Road, lower\",Net,3,500,yes,no,2000,4,3,0.75,0.25,1,2,1,1,0,3,15,4.5\n");
}

TEST(DesignTables, NameTheLimitOfAKit) {
  KitChoice kit = small_result().ranking.front();
  EXPECT_EQ(limit_text(small_plan(), kit), "");
  kit.caught->of = 4501;
  kit.beside = 890;
  kit.limit = KitLimit::ends;
  EXPECT_EQ(limit_text(small_plan(), kit), "890 of 4,501 pass beyond the ends of the line: lengthen it");
  kit.limit = KitLimit::clearance;
  EXPECT_EQ(limit_text(small_plan(), kit),
            "its net needs 5.5 m to what is protected, and there are 6 m: choose one that elongates less, or move the "
            "line");
  kit.above = 1234567;
  kit.limit = KitLimit::height;
  EXPECT_EQ(limit_text(small_plan(), kit), "1,234,567 of 4,501 reach above 3 m: give higher kits");
  kit.limit = KitLimit::energy;
  kit.through = 2;
  EXPECT_EQ(limit_text(small_plan(), kit), "2 of 4,501 have more energy than the kit may have: give stronger kits");
  kit.kit.reset();
  kit.limit = KitLimit::height;
  EXPECT_EQ(limit_text(small_plan(), kit), "1,234,567 of 4,501 reach above 3 m: give greater heights_m");
  kit.through = 12;
  kit.limit = KitLimit::energy;
  EXPECT_EQ(limit_text(small_plan(), kit), "12 of 4,501 have more than 500 kJ: give greater energies_kJ");
}

TEST(DesignTables, AreWrittenAndRemoved) {
  const test::Workplace work;
  write_design_tables(work / "", small_plan(), small_result());
  EXPECT_EQ(work.read("design.csv"), design_table(small_plan(), small_result()));
  EXPECT_EQ(work.read("design_ranking.csv"), ranking_table(small_plan(), small_result()));
  EXPECT_EQ(work.read("design_pairs.csv"), pair_table(small_plan(), small_result()));
  remove_design_tables(work / "");
  EXPECT_TRUE(std::filesystem::is_empty(work / ""));
  EXPECT_THROW(write_design_tables(work / "nowhere", small_plan(), small_result()), BadInput);
}

TEST(DesignJson, HasTheFiguresOfTheReport) {
  const Json json = design_json(small_plan(), small_result());
  EXPECT_EQ(json["standard"], "UNI 11211-4");
  EXPECT_EQ(json["factors"]["energy"], 1.1);
  EXPECT_EQ(json["standard_not_read"], "The text");
  EXPECT_EQ(json["applied_factors"].dump(),
            R"([{"symbol":"γ_R","key":"risk_factor","multiplies":"energy","value":1.1,"source":"Users of it",)"
            R"("not_read":"Its classes"}])");
  const Json& line = json["lines"][0];
  EXPECT_EQ(line["name"], "Road, lower");
  EXPECT_EQ(line["percentiles"]["height_m"].dump(), R"({"97.5":[2.0,1.5,null]})");
  EXPECT_EQ(line["needs_at_upper_end"].dump(), R"({"energy_J":260000.0,"class":2,"height_m":4.0})");
  EXPECT_EQ(line["sections"][1]["percentiles"]["height_m"].dump(), "{}");
  EXPECT_EQ(line["sections"][1]["needs"], nullptr);
  EXPECT_EQ(json["best"], json["ranking"][0]);
  EXPECT_EQ(json["best"]["sure"], false);
  DesignResult result = small_result();
  result.ranking[0].suffices = false;
  EXPECT_EQ(design_json(small_plan(), result)["best"], nullptr);
}

TEST(DesignJson, RestoresAPlan) {
  DesignPlan plan = small_plan();
  EXPECT_EQ(plan_from(Json::parse(plan_json(plan).dump()), 2), plan);
  plan.protect.reset();
  plan.factors.level = KitLevel::service;
  plan.factors.takes_total_energy = true;
  plan.factors.block_mass.reset();
  plan.standard.clear();
  EXPECT_EQ(plan_from(Json::parse(plan_json(plan).dump()), 2), plan);
}

TEST(DesignJson, RefusesAnInvalidPlan) {
  const auto refused = [](const std::function<void(Json&)>& change) {
    Json json = plan_json(small_plan());
    change(json);
    try {
      (void)plan_from(json, 2);
    } catch (const BadBytes&) {
      return true;
    } catch (const nlohmann::json::exception&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused([](Json&) {}));
  EXPECT_TRUE(refused([](Json& json) { json["lines"][0]["barrier"] = 2; }));
  EXPECT_TRUE(refused([](Json& json) { json["lines"][0]["sections"] = 0; }));
  EXPECT_TRUE(refused([](Json& json) { json["lines"][0]["sections"] = 1001; }));
  EXPECT_TRUE(refused([](Json& json) { json["lines"][0]["section_m"] = 0; }));
  EXPECT_TRUE(refused([](Json& json) { json["protect"] = 2; }));
  EXPECT_TRUE(refused([](Json& json) { json["confidence"] = 1; }));
  EXPECT_TRUE(refused([](Json& json) { json["percentiles"] = {101}; }));
  EXPECT_TRUE(refused([](Json& json) { json["heights_m"] = {3, 3}; }));
  EXPECT_TRUE(refused([](Json& json) { json["factors"].erase("energy"); }));
  EXPECT_TRUE(refused([](Json& json) { json["lines"][1]["clearances_m"] = {6, 6}; }));
  EXPECT_TRUE(refused([](Json& json) { json["kits"][0]["heights_m"] = {2}; })) << "no rock is counted by it";
  EXPECT_TRUE(refused([](Json& json) { json["kits"][0]["checked_energy_J"] = 1; }));
  EXPECT_TRUE(refused([](Json& json) { json["kits"][0]["residual_share"] = 0.3; }));
  EXPECT_TRUE(refused([](Json& json) { json["pairs"][0]["lines"] = {0, 2}; }));
  EXPECT_TRUE(refused([](Json& json) { json["pairs"][0]["lines"] = {1, 0}; }));
}

}  // namespace
}  // namespace talus
