#include "talus/archive/design_tables.hpp"

#include <fmt/format.h>

#include <system_error>

#include "talus/archive/design_json.hpp"
#include "talus/files/output_file.hpp"

namespace talus {

namespace {

constexpr const char* interval_ends[] = {"", "_low", "_high"};

std::optional<std::uint64_t> class_of(const std::optional<int>& kit_class) {
  return kit_class ? std::optional(static_cast<std::uint64_t>(*kit_class)) : std::nullopt;
}

std::vector<std::string> percentile_columns(const std::vector<double>& percentiles) {
  std::vector<std::string> names;
  for (const DesignQuantity& quantity : design_quantities) {
    for (const double percentile : percentiles) {
      for (const char* end : interval_ends)
        names.push_back(design_column(quantity, fmt::format("{}", percentile), end));
    }
  }
  return names;
}

DesignRow row_of(const DesignPlan& plan, const DesignLine& line, std::string section, const DesignFigures& figures) {
  DesignRow row{.line = line.name,
                .section = std::move(section),
                .from_m = figures.from,
                .to_m = figures.to,
                .rocks = figures.rocks};
  if (const auto& share = figures.share) {
    row.share = share->value;
    row.share_low = share->low;
    row.share_high = share->high;
  }
  for (const std::vector<Estimate>& estimates : figures.percentiles) {
    for (std::size_t k = 0; k < plan.percentiles.size(); ++k) {
      const bool is_known = k < estimates.size();
      row.percentiles.push_back(is_known ? std::optional(estimates[k].value) : std::nullopt);
      row.percentiles.push_back(is_known ? estimates[k].low : std::nullopt);
      row.percentiles.push_back(is_known ? estimates[k].high : std::nullopt);
    }
  }
  if (const auto& demand = figures.demand) {
    row.needs_mel_kJ = demand->maximum_energy / 1000;
    row.needs_class = class_of(demand->kit_class);
    row.needs_height_m = demand->height;
  }
  if (const auto& demand = figures.demand_at_upper_end) {
    row.needs_high_mel_kJ = demand->maximum_energy / 1000;
    row.needs_high_class = class_of(demand->kit_class);
    row.needs_high_height_m = demand->height;
  }
  row.largest_block_m = figures.largest_block;
  row.lateral = figures.lateral;
  row.clearance_m = figures.clearance;
  row.most_elongation_m = figures.most_elongation;
  return row;
}

/// The columns of the rocks that count and the caught ones.
template <class Row>
void fill_caught(Row& row, const std::optional<RockShare>& caught) {
  if (!caught) return;
  row.rocks = caught->of;
  row.caught = caught->rocks;
  row.caught_share = caught->value;
  row.caught_share_low = caught->low;
  row.caught_share_high = caught->high;
}

RankingRow row_of(const DesignPlan& plan, const KitChoice& kit, std::uint64_t rank) {
  const DesignLine& line = plan.lines[kit.line];
  RankingRow row{.rank = rank,
                 .line = line.name,
                 .length_m = line.length,
                 .height_m = kit.height,
                 .mel_kJ = kit.maximum_energy / 1000,
                 .kit_class = class_of(kit.kit_class),
                 .suffices = kit.suffices,
                 .is_sure = kit.is_sure,
                 .cost = kit.cost};
  fill_caught(row, kit.caught);
  row.above = kit.above;
  row.through = kit.through;
  row.beside = kit.beside;
  row.limit = limit_text(plan, kit);
  if (kit.kit) row.kit = plan.kits[*kit.kit].name;
  row.needs_clearance_m = kit.needed_clearance;
  row.clearance_m = kit.clearance;
  row.residual_height_m = kit.residual_height;
  if (kit.below_residual) row.below_residual_share = kit.below_residual->value;
  return row;
}

PairRow row_of(const DesignPlan& plan, const PairChoice& choice, std::uint64_t rank) {
  const auto name_of = [&](const PairKit& kit) { return kit.kit ? plan.kits[*kit.kit].name : std::string(); };
  const DesignPair& pair = plan.pairs[choice.pair];
  PairRow row{.rank = rank,
              .first = plan.lines[choice.first.line].name,
              .first_kit = name_of(choice.first),
              .first_height_m = choice.first.height,
              .first_mel_kJ = choice.first.maximum_energy / 1000,
              .second = plan.lines[choice.second.line].name,
              .second_kit = name_of(choice.second),
              .second_height_m = choice.second.height,
              .second_mel_kJ = choice.second.maximum_energy / 1000,
              .suffices = choice.suffices,
              .is_sure = choice.is_sure,
              .cost = choice.cost};
  fill_caught(row, choice.caught);
  row.caught_by_first = choice.by_first;
  row.at_second = choice.at_second;
  row.caught_by_second = choice.by_second;
  row.beside = choice.beside;
  row.overlap_m = pair.overlap;
  row.distance_m = pair.distance;
  row.needs_overlap_m = choice.needed_overlap;
  return row;
}

}  // namespace

std::string key_of(const DesignQuantity& quantity) {
  return fmt::format("{}_{}", quantity.name, quantity.unit_in_name);
}

std::string design_column(const DesignQuantity& quantity, std::string_view percentile, std::string_view end) {
  return fmt::format("{}_p{}{}_{}", quantity.name, percentile, end, quantity.unit_in_name);
}

std::vector<ColumnText> DesignRow::family_texts() {
  std::vector<ColumnText> texts;
  const auto add = [&](const DesignQuantity& quantity, const char* end, std::string meaning) {
    texts.push_back({design_column(quantity, "…", end), std::string(quantity.unit), std::move(meaning)});
  };
  for (const DesignQuantity& quantity : design_quantities) {
    add(quantity, interval_ends[0], fmt::format("{}: each of `percentiles`", quantity.meaning));
    add(quantity, interval_ends[1], "lower end of its confidence interval");
    add(quantity, interval_ends[2], "upper end of its confidence interval");
  }
  return texts;
}

std::string design_table(const DesignPlan& plan, const DesignResult& result) {
  std::string text = header_of<DesignRow>(percentile_columns(plan.percentiles));
  for (std::size_t k = 0; k < plan.lines.size(); ++k) {
    const DesignResult::Line& line = result.lines[k];
    append_row(text, row_of(plan, plan.lines[k], "all", line.whole));
    for (std::size_t s = 0; s < line.sections.size(); ++s)
      append_row(text, row_of(plan, plan.lines[k], fmt::format("{}", s + 1), line.sections[s]));
  }
  return text;
}

std::string ranking_table(const DesignPlan& plan, const DesignResult& result) {
  std::string text = header_of<RankingRow>();
  std::uint64_t rank = 0;
  for (const KitChoice& kit : result.ranking) append_row(text, row_of(plan, kit, ++rank));
  return text;
}

std::string pair_table(const DesignPlan& plan, const DesignResult& result) {
  std::string text = header_of<PairRow>();
  std::uint64_t rank = 0;
  for (const PairChoice& pair : result.pairs) append_row(text, row_of(plan, pair, ++rank));
  return text;
}

void write_design_tables(const std::filesystem::path& folder, const DesignPlan& plan, const DesignResult& result) {
  write_file(folder / DesignRow::file_name, design_table(plan, result));
  write_file(folder / RankingRow::file_name, ranking_table(plan, result));
  if (!plan.pairs.empty()) write_file(folder / PairRow::file_name, pair_table(plan, result));
}

void remove_design_tables(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder / DesignRow::file_name, ignored);
  std::filesystem::remove(folder / RankingRow::file_name, ignored);
  std::filesystem::remove(folder / PairRow::file_name, ignored);
}

}  // namespace talus
