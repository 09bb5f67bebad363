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
  plan.lines = {{"Road, lower", 1, 15.5, 10, 2}};
  plan.protect = 0;
  plan.percentiles = {97.5};
  plan.standard = "UNI 11211-4";
  plan.factors.risk = 1.1;
  plan.factors.block_mass = 1500;
  plan.heights = {3};
  plan.energies = {500e3};
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
  result.lines = {{whole, {first, second}}};
  result.ranking = {{.line = 0,
                     .height = 3,
                     .maximum_energy = 500e3,
                     .kit_class = 2,
                     .suffices = true,
                     .is_sure = false,
                     .caught = RockShare{3, 4, 0.75, 0.25, 1},
                     .above = 1,
                     .through = 0,
                     .beside = 0,
                     .cost = 1039.5}};
  return result;
}

TEST(DesignTables, HaveTheExpectedText) {
  EXPECT_EQ(design_table(small_plan(), small_result()),
            "line,section,from_m,to_m,rocks,share,share_low,share_high,"
            "ke_translational_p97.5_J,ke_translational_p97.5_low_J,ke_translational_p97.5_high_J,"
            "ke_total_p97.5_J,ke_total_p97.5_low_J,ke_total_p97.5_high_J,"
            "velocity_p97.5_m_s,velocity_p97.5_low_m_s,velocity_p97.5_high_m_s,"
            "height_p97.5_m,height_p97.5_low_m,height_p97.5_high_m,"
            "needs_mel_kJ,needs_class,needs_height_m,needs_high_mel_kJ,needs_high_class,needs_high_height_m\n"
            "\"Road, lower\",all,0,15.5,3,0.25,0.125,0.5,1000,500,,1100,550,,10,5,,2,1.5,,1.2,0,2.5,260,2,4\n"
            "\"Road, lower\",1,0,10,3,0.25,0.125,0.5,1000,500,,1100,550,,10,5,,2,1.5,,1.2,0,2.5,,,\n"
            "\"Road, lower\",2,10,15.5,0,0,0,0.25,,,,,,,,,,,,,,,,,,\n");
  EXPECT_EQ(ranking_table(small_plan(), small_result()),
            "rank,line,length_m,height_m,mel_kJ,class,suffices,sure,cost,rocks,caught,caught_share,caught_share_low,"
            "caught_share_high,above,through,beside,limit\n"
            "1,\"Road, lower\",15.5,3,500,2,yes,no,1039.5,4,3,0.75,0.25,1,1,0,0,\n");
}

TEST(DesignTables, NameTheLimitOfAKit) {
  KitChoice kit = small_result().ranking.front();
  EXPECT_EQ(limit_text(small_plan(), kit), "");
  kit.caught->of = 4501;
  kit.beside = 890;
  kit.limit = KitLimit::ends;
  EXPECT_EQ(limit_text(small_plan(), kit), "890 of 4,501 pass beyond the ends of the line: lengthen it");
  kit.above = 1234567;
  kit.limit = KitLimit::height;
  EXPECT_EQ(limit_text(small_plan(), kit), "1,234,567 of 4,501 pass above 3 m: give greater heights_m");
  kit.through = 12;
  kit.limit = KitLimit::energy;
  EXPECT_EQ(limit_text(small_plan(), kit), "12 of 4,501 have more than 500 kJ: give greater energies_kJ");
}

TEST(DesignTables, AreWrittenAndRemoved) {
  const test::Workplace work;
  write_design_tables(work / "", small_plan(), small_result());
  EXPECT_EQ(work.read("design.csv"), design_table(small_plan(), small_result()));
  EXPECT_EQ(work.read("design_ranking.csv"), ranking_table(small_plan(), small_result()));
  remove_design_tables(work / "");
  EXPECT_TRUE(std::filesystem::is_empty(work / ""));
  EXPECT_THROW(write_design_tables(work / "nowhere", small_plan(), small_result()), BadInput);
}

TEST(DesignJson, HasTheFiguresOfTheReport) {
  const Json json = design_json(small_plan(), small_result());
  EXPECT_EQ(json["standard"], "UNI 11211-4");
  EXPECT_EQ(json["factors"]["risk"], 1.1);
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
  EXPECT_TRUE(refused([](Json& json) { json["factors"].erase("risk"); }));
}

}  // namespace
}  // namespace talus
