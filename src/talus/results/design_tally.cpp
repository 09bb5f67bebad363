#include "talus/results/design_tally.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace talus {

namespace {

constexpr const char* damaged = "the counts for the design of barriers are damaged";

}  // namespace

SectionTally::SectionTally(std::uint64_t planned_rocks)
    : sketches(crossing_quantity_count, QuantileSketch(planned_rocks)) {}

void SectionTally::add(const LineCrossing& crossing) {
  for (std::size_t k = 0; k < crossing_quantity_count; ++k) sketches[k].add(crossing.values[k]);
  largest_block = std::max(largest_block, crossing.diameter);
}

void SectionTally::merge(const SectionTally& other) {
  for (std::size_t k = 0; k < sketches.size(); ++k) sketches[k].merge(other.sketches[k]);
  largest_block = std::max(largest_block, other.largest_block);
}

std::uint64_t KitDemands::rocks() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }

std::uint64_t KitDemands::caught(std::size_t height, std::size_t energy) const {
  std::uint64_t sum = 0;
  for (std::size_t h = 0; h <= height; ++h) {
    for (std::size_t e = 0; e <= energy; ++e) sum += at(h, e);
  }
  return sum;
}

std::uint64_t KitDemands::above(std::size_t height) const {
  const auto first = counts_.begin() + static_cast<std::ptrdiff_t>((height + 1) * columns_);
  return std::accumulate(first, counts_.end(), std::uint64_t{0});
}

void KitDemands::save(ByteWriter& out) const { out.list(counts_); }

void KitDemands::merge_saved(ByteReader& in) {
  const auto saved = in.list<std::uint64_t>();
  expect_bytes(saved.size() == counts_.size(), "the design of barriers has other kits");
  for (std::size_t k = 0; k < saved.size(); ++k) {
    expect_bytes(saved[k] <= std::uint64_t{1} << 60, damaged);
    counts_[k] += saved[k];
  }
}

std::uint64_t PairCounts::rocks() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }

void PairCounts::save(ByteWriter& out) const {
  out.list(counts_);
  out.put(one_first);
  out.put(other_first);
}

void PairCounts::merge_saved(ByteReader& in) {
  const auto saved = in.list<std::uint64_t>();
  expect_bytes(saved.size() == counts_.size(), "the design of barriers has other kits");
  for (std::size_t k = 0; k < saved.size(); ++k) {
    expect_bytes(saved[k] <= std::uint64_t{1} << 60, damaged);
    counts_[k] += saved[k];
  }
  one_first += in.get<std::uint64_t>();
  other_first += in.get<std::uint64_t>();
}

DesignTally::DesignTally(const DesignPlan& plan, std::uint64_t planned_rocks) {
  for (const DesignLine& line : plan.lines) {
    lines.push_back({std::vector<SectionTally>(line.sections, SectionTally(planned_rocks)),
                     KitDemands(plan.heights.size(), plan.energies.size())});
  }
  pairs.assign(plan.pairs.size(), PairCounts(plan.kit_classes()));
}

void DesignTally::save(ByteWriter& out) const {
  out.put(rocks);
  out.count(lines.size());
  for (const Line& line : lines) {
    out.count(line.sections.size());
    for (const SectionTally& section : line.sections) {
      for (const QuantileSketch& sketch : section.sketches) sketch.save(out);
      out.put(section.largest_block);
    }
    line.demands.save(out);
    out.put(line.beside);
  }
  out.count(pairs.size());
  for (const PairCounts& pair : pairs) pair.save(out);
}

void DesignTally::merge_saved(ByteReader& in) {
  constexpr const char* other = "the design of barriers has other lines";
  rocks += in.get<std::uint64_t>();
  expect_bytes(in.get<std::uint64_t>() == lines.size(), other);
  for (Line& line : lines) {
    expect_bytes(in.get<std::uint64_t>() == line.sections.size(), other);
    std::uint64_t crossings = 0;
    for (SectionTally& section : line.sections) {
      for (QuantileSketch& sketch : section.sketches) {
        sketch.merge_saved(in);
        expect_bytes(sketch.count() == section.rocks() && (sketch.count() == 0 || *sketch.quantile(0) >= 0), damaged);
      }
      const auto largest_block = in.get<double>();
      expect_bytes(std::isfinite(largest_block) && largest_block >= 0, damaged);
      section.largest_block = std::max(section.largest_block, largest_block);
      crossings += section.rocks();
    }
    line.demands.merge_saved(in);
    line.beside += in.get<std::uint64_t>();
    expect_bytes(crossings <= rocks && line.beside <= rocks && line.demands.rocks() <= crossings, damaged);
  }
  expect_bytes(in.get<std::uint64_t>() == pairs.size(), other);
  for (PairCounts& pair : pairs) {
    pair.merge_saved(in);
    expect_bytes(pair.rocks() <= rocks && pair.one_first <= rocks && pair.other_first <= rocks, damaged);
  }
}

/// Crossings of a block of rocks: a few numbers per rock, added when the block is committed.
class DesignObserver::Part : public ObserverPart {
 public:
  Part(const DesignPlan& plan, const DesignTally& tally)
      : beside(plan.lines.size()), plan_(plan), tally_(tally), at_lines_(plan.lines.size()) {}

  void see(const RockRecord& record, const RockLog& log) override {
    ++rocks;
    const Passage* const reached = plan_.protect ? first_passage(log, *plan_.protect) : nullptr;
    for (std::uint32_t k = 0; k < plan_.lines.size(); ++k) {
      const DesignLine& line = plan_.lines[k];
      const Passage* const crossing = first_passage(log, line.barrier);
      const bool counts = (plan_.protect ? reached : crossing) != nullptr;
      const bool is_met = crossing != nullptr &&
                          (reached == nullptr || crossing->motion.time <= reached->motion.time) &&
                          !line.is_at_free_end(crossing->station, plan_.free_end);
      if (counts && !is_met) ++beside[k];
      at_lines_[k] = {};
      if (crossing == nullptr) continue;
      crossings.push_back({k, counts && is_met, line_crossing(plan_, line, record.body, *crossing)});
      at_lines_[k].time = crossing->motion.time;
      if (is_met)
        at_lines_[k].kit = tally_.lines[k].demands.number(crossings.back().at.height, crossings.back().at.energy);
    }
    for (std::uint32_t k = 0; k < plan_.pairs.size(); ++k) add_pair(k, reached != nullptr);
  }

  struct Crossing {
    std::uint32_t line;
    bool counts;
    LineCrossing at;
  };
  struct PairCrossing {
    std::uint32_t pair;
    std::uint32_t one, other;  // classes of kits
    bool one_first, other_first;
  };
  std::uint64_t rocks = 0;
  std::vector<Crossing> crossings;
  std::vector<PairCrossing> pair_crossings;
  std::vector<std::uint64_t> beside;  // of each line

 private:
  void add_pair(std::uint32_t pair, bool is_reached) {
    const AtLine &one = at_lines_[plan_.pairs[pair].one], &other = at_lines_[plan_.pairs[pair].other];
    if (plan_.protect ? !is_reached : !one.time && !other.time) return;
    const std::size_t none = tally_.pairs[pair].none();
    const bool crosses_both = one.time && other.time;
    pair_crossings.push_back({pair, static_cast<std::uint32_t>(one.kit.value_or(none)),
                              static_cast<std::uint32_t>(other.kit.value_or(none)),
                              crosses_both && *one.time < *other.time, crosses_both && *other.time < *one.time});
  }

  /// A rock at a line.
  struct AtLine {
    std::optional<double> time;      // of its first crossing; nullopt: none
    std::optional<std::size_t> kit;  // the class that catches it; nullopt: none can
  };

  const DesignPlan& plan_;
  const DesignTally& tally_;  // of its sizes only
  std::vector<AtLine> at_lines_;
};

DesignObserver::DesignObserver(DesignPlan plan, std::uint64_t planned_rocks)
    : plan_(std::move(plan)), tally_(plan_, planned_rocks) {}

std::unique_ptr<ObserverPart> DesignObserver::new_part() const { return std::make_unique<Part>(plan_, tally_); }

void DesignObserver::commit(ObserverPart& part) {
  const auto& seen = static_cast<Part&>(part);
  tally_.rocks += seen.rocks;
  for (std::size_t k = 0; k < tally_.lines.size(); ++k) tally_.lines[k].beside += seen.beside[k];
  for (const Part::Crossing& crossing : seen.crossings) {
    DesignTally::Line& line = tally_.lines[crossing.line];
    line.sections[crossing.at.section].add(crossing.at);
    if (crossing.counts) line.demands.add(crossing.at.height, crossing.at.energy);
  }
  for (const Part::PairCrossing& crossing : seen.pair_crossings) {
    PairCounts& pair = tally_.pairs[crossing.pair];
    pair.add(crossing.one, crossing.other);
    pair.one_first += crossing.one_first ? 1 : 0;
    pair.other_first += crossing.other_first ? 1 : 0;
  }
}

}  // namespace talus
