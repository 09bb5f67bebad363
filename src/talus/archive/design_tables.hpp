#pragma once
// design.csv, design_ranking.csv and design_pairs.csv: the design of barriers for spreadsheets.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "talus/files/csv_table.hpp"
#include "talus/results/design_result.hpp"

namespace talus {

/// A quantity that percentiles along a line are taken of, and how its columns are named.
struct DesignQuantity {
  std::string_view name, unit_in_name, unit, meaning;
};
/// By CrossingQuantity.
inline constexpr std::array<DesignQuantity, shown_quantity_count> design_quantities{
    {{"ke_translational", "J", "J", "translational kinetic energy"},
     {"ke_total", "J", "J", "total kinetic energy"},
     {"velocity", "m_s", "m/s", "velocity"},
     {"height", "m", "m", "height of the block's top above the foot, along the face"}}};

/// "ke_total_J", in summary.json.
[[nodiscard]] std::string key_of(const DesignQuantity& quantity);
/// "ke_total_p95_low_J"; `percentile` as it is in the name.
[[nodiscard]] std::string design_column(const DesignQuantity& quantity, std::string_view percentile,
                                        std::string_view end = "");

/// A row of design.csv: a section of a line, or the whole line. What is not known, for too few rocks, is empty.
struct DesignRow {
  static constexpr const char* file_name = "design.csv";

  std::string line{}, section{};
  double from_m = 0, to_m = 0;
  std::uint64_t rocks = 0;
  std::optional<double> share{}, share_low{}, share_high{};
  FamilyValues percentiles{};  // by quantity, by percentile: value, lower end, upper end
  std::optional<double> needs_mel_kJ{};
  std::optional<std::uint64_t> needs_class{};
  std::optional<double> needs_height_m{}, needs_high_mel_kJ{};
  std::optional<std::uint64_t> needs_high_class{};
  std::optional<double> needs_high_height_m{}, largest_block_m{}, lateral{}, clearance_m{}, most_elongation_m{};

  static constexpr auto columns() {
    using R = DesignRow;
    return std::tuple(
        word("line", "name of the barrier or collector", &R::line),
        word("section", "number of the section, from 1; `all`: the whole line", &R::section),
        quantity("from_m", "m", "where it begins along the line on plan, from the first point as it was given",
                 &R::from_m),
        quantity("to_m", "m", "where it ends", &R::to_m),
        quantity("rocks", "", "rocks that cross it first of all sections", &R::rocks),
        quantity("share", "", "share of all rocks of the run", &R::share),
        quantity("share_low", "", "lower end of its confidence interval", &R::share_low),
        quantity("share_high", "", "upper end of its confidence interval", &R::share_high), family(&R::percentiles),
        quantity("needs_mel_kJ", "kJ", "maximum energy level that the check asks for, by `design_percentile`",
                 &R::needs_mel_kJ),
        quantity("needs_class", "", "energy class that it asks for", &R::needs_class),
        quantity("needs_height_m", "m", "nominal height that it asks for: at least that of the block's top",
                 &R::needs_height_m),
        quantity("needs_high_mel_kJ", "kJ", "the same by the upper ends of the confidence intervals",
                 &R::needs_high_mel_kJ),
        quantity("needs_high_class", "", "the same", &R::needs_high_class),
        quantity("needs_high_height_m", "m", "the same", &R::needs_high_height_m),
        quantity("lateral", "", "3D: metres along the line per metre across it, on plan: `design_percentile`",
                 &R::lateral),
        quantity("clearance_m", "m", "distance on plan to what is protected, D_A", &R::clearance_m),
        quantity("most_elongation_m", "m", "elongation in its test that a kit may have there at most, D_A / k_d",
                 &R::most_elongation_m),
        quantity("largest_block_m", "m", "diameter of the largest rock that crosses it", &R::largest_block_m));
  }
  [[nodiscard]] static std::vector<ColumnText> family_texts();
};

/// A row of design_ranking.csv: a kit on a line.
struct RankingRow {
  static constexpr const char* file_name = "design_ranking.csv";

  std::uint64_t rank = 0;
  std::string line{};
  double length_m = 0, height_m = 0, mel_kJ = 0;
  std::optional<std::uint64_t> kit_class{};
  bool suffices = false, is_sure = false;
  double cost = 0;
  std::uint64_t rocks = 0, caught = 0;
  std::optional<double> caught_share{}, caught_share_low{}, caught_share_high{};
  std::uint64_t above = 0, through = 0, beside = 0;
  std::string limit{};
  std::string kit{};
  std::optional<double> needs_clearance_m{}, clearance_m{}, residual_height_m{}, below_residual_share{};

  static constexpr auto columns() {
    using R = RankingRow;
    return std::tuple(
        key("rank", "place of the kit, from 1", &R::rank), word("line", "name of the barrier or collector", &R::line),
        quantity("length_m", "m", "length of the line on plan", &R::length_m),
        quantity("height_m", "m", "nominal height of the kit", &R::height_m),
        quantity("mel_kJ", "kJ", "its maximum energy level", &R::mel_kJ),
        quantity("class", "", "its energy class", &R::kit_class),
        word("suffices",
             "`yes`: it catches `catch_share` of the rocks; if no energy is enough, the row has the least that catches "
             "the most",
             &R::suffices),
        word("sure",
             "`yes`: the whole confidence interval of that share is on the same side of `catch_share`. With `no` too "
             "few rocks were run: a kit that catches 95.5 % of them, with an interval from 93.3 to 97.2 %, suffices "
             "for 95 %, and is not sure. Run more rocks",
             &R::is_sure),
        quantity("cost", "", "the cost index", &R::cost), quantity("rocks", "", "rocks that count", &R::rocks),
        quantity("caught", "", "rocks that it catches", &R::caught),
        quantity("caught_share", "", "their share", &R::caught_share),
        quantity("caught_share_low", "", "lower end of its confidence interval", &R::caught_share_low),
        quantity("caught_share_high", "", "upper end of its confidence interval", &R::caught_share_high),
        quantity("above", "", "rocks that are not caught because their tops are too high", &R::above),
        quantity("through", "", "because they have too much energy", &R::through),
        quantity("beside", "", "because they are never at the line, or at its free ends", &R::beside),
        word("limit",
             "what keeps the kit from catching `catch_share`, and what would help: the clearance, else the ends of the "
             "line, else its height, else its energy",
             &R::limit),
        word("kit", "name of the `[[kit]]`", &R::kit),
        quantity("needs_clearance_m", "m", "distance on plan that its elongation needs, D_d", &R::needs_clearance_m),
        quantity("clearance_m", "m", "the smallest distance on plan from the line to what is protected, D_A",
                 &R::clearance_m),
        quantity("residual_height_m", "m", "height that remains at least after an impact at its MEL",
                 &R::residual_height_m),
        quantity("below_residual_share", "",
                 "share of the rocks that pass the check with that height, whatever their energy",
                 &R::below_residual_share));
  }
};

/// A row of design_pairs.csv: two lines, one behind the other, with a kit each.
struct PairRow {
  static constexpr const char* file_name = "design_pairs.csv";

  std::uint64_t rank = 0;
  std::string first{}, first_kit{};
  double first_height_m = 0, first_mel_kJ = 0;
  std::string second{}, second_kit{};
  double second_height_m = 0, second_mel_kJ = 0;
  bool suffices = false, is_sure = false;
  double cost = 0;
  std::uint64_t rocks = 0, caught = 0;
  std::optional<double> caught_share{}, caught_share_low{}, caught_share_high{};
  std::uint64_t caught_by_first = 0, at_second = 0, caught_by_second = 0, beside = 0;
  std::optional<double> overlap_m{}, distance_m{}, needs_overlap_m{};

  static constexpr auto columns() {
    using R = PairRow;
    return std::tuple(
        key("rank", "place of the pair, from 1", &R::rank),
        word("first", "the line that most of the rocks that cross both cross first", &R::first),
        word("first_kit", "name of the `[[kit]]` there", &R::first_kit),
        quantity("first_height_m", "m", "nominal height of the kit", &R::first_height_m),
        quantity("first_mel_kJ", "kJ", "its maximum energy level", &R::first_mel_kJ),
        word("second", "the other line", &R::second), word("second_kit", "the same", &R::second_kit),
        quantity("second_height_m", "m", "the same", &R::second_height_m),
        quantity("second_mel_kJ", "kJ", "the same", &R::second_mel_kJ),
        word("suffices", "`yes`: together they catch `catch_share` of the rocks", &R::suffices),
        word("sure", "`yes`: the whole confidence interval of that share is on the same side of `catch_share`",
             &R::is_sure),
        quantity("cost", "", "cost of both", &R::cost), quantity("rocks", "", "rocks that count", &R::rocks),
        quantity("caught", "", "rocks that either catches; of spheres at least, which also touch its top", &R::caught),
        quantity("caught_share", "", "their share", &R::caught_share),
        quantity("caught_share_low", "", "lower end of its confidence interval", &R::caught_share_low),
        quantity("caught_share_high", "", "upper end of its confidence interval", &R::caught_share_high),
        quantity("caught_by_first", "", "rocks that the first catches", &R::caught_by_first),
        quantity("at_second", "", "others that are at the second", &R::at_second),
        quantity("caught_by_second", "", "of these, rocks that it catches", &R::caught_by_second),
        quantity("beside", "", "rocks that are never at either line, or at their free ends", &R::beside),
        quantity("overlap_m", "m", "staggered lines: how far they overlap on plan; negative: the gap between them",
                 &R::overlap_m),
        quantity("distance_m", "m", "the distance between them there", &R::distance_m),
        quantity("needs_overlap_m", "m",
                 "overlap that the directions of the rocks ask for: that distance times `lateral` of the first line",
                 &R::needs_overlap_m));
  }
};

/// A row for each section of every line, and one for the whole line.
[[nodiscard]] std::string design_table(const DesignPlan& plan, const DesignResult& result);
/// A row for each kit, the best first.
[[nodiscard]] std::string ranking_table(const DesignPlan& plan, const DesignResult& result);

/// A row for each choice of two kits, the best first.
[[nodiscard]] std::string pair_table(const DesignPlan& plan, const DesignResult& result);

/// Writes them into a run's folder, the pairs only if the plan has any. Throws BadInput if that fails.
void write_design_tables(const std::filesystem::path& folder, const DesignPlan& plan, const DesignResult& result);
/// Removes those that an earlier run left there.
void remove_design_tables(const std::filesystem::path& folder);

}  // namespace talus
