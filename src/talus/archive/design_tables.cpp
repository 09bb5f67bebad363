#include "talus/archive/design_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "talus/archive/design_json.hpp"
#include "talus/files/csv_text.hpp"
#include "talus/files/output_file.hpp"

namespace talus::io {

namespace {

constexpr const char* design_name = "design.csv";
constexpr const char* ranking_name = "design_ranking.csv";

constexpr std::array<std::pair<std::string_view, std::string_view>, crossing_quantity_count - 1> quantities{
    {{"ke_translational", "J"}, {"ke_total", "J"}, {"velocity", "m_s"}, {"height", "m"}}};

void put(CsvRow& row, const std::optional<double>& value) {
  if (value) {
    row << *value;
  } else {
    row << "";
  }
}

void put(CsvRow& row, const std::optional<RockShare>& share) {
  put(row, share ? std::optional(share->value) : std::nullopt);
  put(row, share ? std::optional(share->low) : std::nullopt);
  put(row, share ? std::optional(share->high) : std::nullopt);
}

void put(CsvRow& row, const std::optional<KitDemand>& demand) {
  if (!demand) {
    row << ""
        << ""
        << "";
    return;
  }
  row << demand->maximum_energy / 1000 << demand->kit_class << demand->height;
}

std::string heading(const DesignPlan& plan) {
  std::string text = "line,section,from_m,to_m,rocks,share,share_low,share_high";
  for (const auto& [quantity, unit] : quantities) {
    for (const double percentile : plan.percentiles) {
      for (const char* end : {"", "_low", "_high"}) {
        text += fmt::format(",{}_p{}{}_{}", quantity, percentile, end, unit);
      }
    }
  }
  for (const char* end : {"", "_high"}) text += fmt::format(",needs{0}_mel_kJ,needs{0}_class,needs{0}_height_m", end);
  return text + "\n";
}

void append(std::string& text, const DesignPlan& plan, const DesignLine& line, std::string_view section,
            const DesignFigures& figures) {
  CsvRow row(text);
  row << line.name << section << figures.from << figures.to << figures.rocks;
  put(row, figures.share);
  for (const std::vector<Estimate>& estimates : figures.percentiles) {
    for (std::size_t k = 0; k < plan.percentiles.size(); ++k) {
      const bool is_known = k < estimates.size();
      put(row, is_known ? std::optional(estimates[k].value) : std::nullopt);
      put(row, is_known ? estimates[k].low : std::nullopt);
      put(row, is_known ? estimates[k].high : std::nullopt);
    }
  }
  put(row, figures.demand);
  put(row, figures.demand_at_upper_end);
  row.end();
}

}  // namespace

std::string design_table(const DesignPlan& plan, const DesignResult& result) {
  std::string text = heading(plan);
  for (std::size_t k = 0; k < plan.lines.size(); ++k) {
    const DesignResult::Line& line = result.lines[k];
    append(text, plan, plan.lines[k], "all", line.whole);
    for (std::size_t s = 0; s < line.sections.size(); ++s) {
      append(text, plan, plan.lines[k], fmt::format("{}", s + 1), line.sections[s]);
    }
  }
  return text;
}

std::string ranking_table(const DesignPlan& plan, const DesignResult& result) {
  std::string text =
      "rank,line,length_m,height_m,mel_kJ,class,suffices,sure,cost,rocks,caught,caught_share,caught_share_low,"
      "caught_share_high,above,through,beside,limit\n";
  std::size_t rank = 0;
  for (const KitChoice& kit : result.ranking) {
    CsvRow row(text);
    row << ++rank << plan.lines[kit.line].name << plan.lines[kit.line].length << kit.height << kit.maximum_energy / 1000
        << (kit.kit_class ? fmt::format("{}", *kit.kit_class) : "") << (kit.suffices ? "yes" : "no")
        << (kit.is_sure ? "yes" : "no") << kit.cost << (kit.caught ? kit.caught->of : 0)
        << (kit.caught ? kit.caught->rocks : 0);
    put(row, kit.caught);
    row << kit.above << kit.through << kit.beside << limit_text(plan, kit);
    row.end();
  }
  return text;
}

void write_design_tables(const std::filesystem::path& folder, const DesignPlan& plan, const DesignResult& result) {
  const auto write = [&](const char* name, const std::string& text) {
    OutputFile file(folder / name);
    file.write(text);
    file.commit();
  };
  write(design_name, design_table(plan, result));
  write(ranking_name, ranking_table(plan, result));
}

void remove_design_tables(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder / design_name, ignored);
  std::filesystem::remove(folder / ranking_name, ignored);
}

}  // namespace talus::io
