#include "talus/results/design_tally.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace talus {

namespace {

constexpr const char* damaged = "the counts for the design of barriers are damaged";

}  // namespace

SectionTally::SectionTally(std::uint64_t planned_rocks)
    : sketches(crossing_quantity_count, QuantileSketch(planned_rocks)) {}

void SectionTally::add(const std::array<double, crossing_quantity_count>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) sketches[k].add(values[k]);
}

void SectionTally::merge(const SectionTally& other) {
  for (std::size_t k = 0; k < sketches.size(); ++k) sketches[k].merge(other.sketches[k]);
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

DesignTally::DesignTally(const DesignPlan& plan, std::uint64_t planned_rocks) {
  for (const DesignLine& line : plan.lines) {
    lines.push_back({std::vector<SectionTally>(line.sections, SectionTally(planned_rocks)),
                     KitDemands(plan.heights.size(), plan.energies.size())});
  }
}

void DesignTally::save(ByteWriter& out) const {
  out.put(rocks);
  out.count(lines.size());
  for (const Line& line : lines) {
    out.count(line.sections.size());
    for (const SectionTally& section : line.sections) {
      for (const QuantileSketch& sketch : section.sketches) sketch.save(out);
    }
    line.demands.save(out);
    out.put(line.beside);
  }
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
      crossings += section.rocks();
    }
    line.demands.merge_saved(in);
    line.beside += in.get<std::uint64_t>();
    expect_bytes(crossings <= rocks && line.beside <= rocks && line.demands.rocks() <= crossings, damaged);
  }
}

namespace {

/// A rock's first crossing of a barrier or collector.
struct FirstCrossing {
  const Motion* motion = nullptr;
  double height = 0, station = 0;
};

std::optional<FirstCrossing> first_crossing_of(const RockLog& log, std::uint32_t barrier) {
  std::optional<FirstCrossing> first;
  const auto consider = [&](const auto& crossings) {
    for (const auto& crossing : crossings) {
      if (crossing.barrier.index != barrier) continue;
      if (!first || crossing.motion.time < first->motion->time) {
        first = FirstCrossing{&crossing.motion, crossing.height, crossing.station};
      }
    }
  };
  consider(log.hits);
  consider(log.passed_above);
  return first;
}

/// Index of the first of the ascending values that is at least `needed`; their number if none is.
std::size_t first_sufficient(const std::vector<double>& rising, double needed) {
  return static_cast<std::size_t>(std::ranges::lower_bound(rising, needed) - rising.begin());
}

}  // namespace

/// Crossings of a block of rocks: a few numbers per rock, added when the block is committed.
class DesignObserver::Part : public ObserverPart {
 public:
  explicit Part(const DesignPlan& plan) : beside(plan.lines.size()), plan_(plan) {}

  void see(const RockRecord& record, const RockLog& log) override {
    ++rocks;
    std::optional<FirstCrossing> reached;
    if (plan_.protect) reached = first_crossing_of(log, *plan_.protect);
    for (std::uint32_t k = 0; k < plan_.lines.size(); ++k) {
      const auto crossing = first_crossing_of(log, plan_.lines[k].barrier);
      const bool counts = plan_.protect ? reached.has_value() : crossing.has_value();
      const bool is_in_time = crossing && (!reached || crossing->motion->time <= reached->motion->time);
      if (counts && !is_in_time) ++beside[k];
      if (crossing) add(k, record.body, *crossing, counts && is_in_time);
    }
  }

  struct Crossing {
    std::uint32_t line, section;
    std::array<double, crossing_quantity_count> values;
    bool counts;
    std::uint32_t height, energy;  // indices of the required kit
  };
  std::uint64_t rocks = 0;
  std::vector<Crossing> crossings;
  std::vector<std::uint64_t> beside;  // of each line

 private:
  void add(std::uint32_t line, const Rock& rock, const FirstCrossing& crossing, bool counts) {
    const double velocity = crossing.motion->velocity.norm();
    const double translational = 0.5 * rock.mass * velocity * velocity;
    const double total = translational + 0.5 * rock.inertia * crossing.motion->spin.squaredNorm();
    const double energy = energy_to_check(plan_.factors, translational, total, velocity);
    constexpr double by_rounding = 1e-6;  // height of a rock that rolls on the ground [m]
    const double height = crossing.height > by_rounding ? crossing.height : 0;
    const double radius = radius_to_check(plan_.factors, rock.mass, rock.radius);
    crossings.push_back(
        {line,
         plan_.lines[line].section_at(crossing.station),
         {translational, total, velocity, height, radius},
         counts,
         static_cast<std::uint32_t>(first_sufficient(plan_.heights, needed_height(plan_.factors, height, radius))),
         static_cast<std::uint32_t>(first_sufficient(plan_.energies, needed_maximum_energy(plan_.factors, energy)))});
  }

  const DesignPlan& plan_;
};

DesignObserver::DesignObserver(DesignPlan plan, std::uint64_t planned_rocks)
    : plan_(std::move(plan)), tally_(plan_, planned_rocks) {}

std::unique_ptr<ObserverPart> DesignObserver::new_part() const { return std::make_unique<Part>(plan_); }

void DesignObserver::commit(ObserverPart& part) {
  const auto& seen = static_cast<Part&>(part);
  tally_.rocks += seen.rocks;
  for (std::size_t k = 0; k < tally_.lines.size(); ++k) tally_.lines[k].beside += seen.beside[k];
  for (const Part::Crossing& crossing : seen.crossings) {
    DesignTally::Line& line = tally_.lines[crossing.line];
    line.sections[crossing.section].add(crossing.values);
    if (crossing.counts) line.demands.add(crossing.height, crossing.energy);
  }
}

}  // namespace talus
