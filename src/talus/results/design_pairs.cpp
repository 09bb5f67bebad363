#include "talus/results/design_pairs.hpp"

#include <algorithm>
#include <tuple>

namespace talus {

namespace {

/// How many rocks the kits of a pair catch: sums of the counts over all classes that a kit covers.
class CaughtByPair {
 public:
  CaughtByPair(const DesignPlan& plan, const PairCounts& counts)
      : heights_(plan.heights.size() + 1), columns_(plan.energies.size() + 1), side_(counts.none() + 1) {
    sums_.resize(side_ * side_);
    for (std::size_t one = 0; one < side_; ++one) {
      for (std::size_t other = 0; other < side_; ++other) sums_[one * side_ + other] = counts.at(one, other);
    }
    sum_up(side_, 1);
    of_one_.assign(side_, 0);
    of_other_.assign(side_, 0);
    for (std::size_t one = 0; one < side_; ++one) {
      for (std::size_t other = 0; other < side_; ++other) of_one_[one] += sums_[one * side_ + other];
    }
    sum_up(1, side_);
    for (std::size_t other = 0; other < side_; ++other) {
      // Of the sums over the classes of the one, the last class of a grid holds all rocks that it meets.
      of_other_[other] = sums_[(side_ - 2) * side_ + other] + sums_[(side_ - 1) * side_ + other];
    }
  }

  [[nodiscard]] std::uint64_t by_one(std::size_t one) const { return of_one_[one]; }
  [[nodiscard]] std::uint64_t by_other(std::size_t other) const { return of_other_[other]; }
  [[nodiscard]] std::uint64_t by_both(std::size_t one, std::size_t other) const { return sums_[one * side_ + other]; }
  /// Rocks that the one meets, whatever kit stands there, and the other catches.
  [[nodiscard]] std::size_t any() const { return side_ - 2; }

 private:
  /// Adds, for each class of one line, the counts of all lower heights and energies: `step` between its classes,
  /// `other` between those of the other line. The class `none` stays by itself.
  void sum_up(std::size_t step, std::size_t other) {
    for (std::size_t k = 0; k < side_; ++k) {
      std::uint64_t* const at = sums_.data() + k * other;
      for (std::size_t h = 0; h < heights_; ++h) {
        for (std::size_t e = 1; e < columns_; ++e) at[(h * columns_ + e) * step] += at[(h * columns_ + e - 1) * step];
      }
      for (std::size_t h = 1; h < heights_; ++h) {
        for (std::size_t e = 0; e < columns_; ++e) at[(h * columns_ + e) * step] += at[((h - 1) * columns_ + e) * step];
      }
    }
  }

  std::size_t heights_, columns_, side_;
  std::vector<std::uint64_t> sums_, of_one_, of_other_;
};

/// A kit that a line may have.
struct Candidate {
  PairKit kit;
  std::size_t kit_class = 0;
  double cost = 0;
};

std::vector<Candidate> candidates_on(const DesignPlan& plan, std::size_t line) {
  std::vector<Candidate> list;
  const auto add = [&](std::optional<std::size_t> kit, double height, double maximum_energy, double checked_energy) {
    const std::size_t number = first_sufficient(plan.heights, height) * (plan.energies.size() + 1) +
                               first_sufficient(plan.energies, checked_energy);
    list.push_back({{line, kit, height, maximum_energy}, number, cost_of(plan, line, kit, height, maximum_energy)});
  };
  if (plan.kits.empty()) {
    for (const double height : plan.heights) {
      for (const double energy : plan.energies) add(std::nullopt, height, energy, energy);
    }
  }
  const auto clearance = plan.lines[line].least_clearance();
  for (std::size_t k = 0; k < plan.kits.size(); ++k) {
    const DesignKit& kit = plan.kits[k];
    const auto needed = kit.elongation ? needed_clearance(plan.factors, *kit.elongation) : std::nullopt;
    if (needed && clearance && *needed > *clearance) continue;  // its net would reach what is protected
    for (const double height : kit.heights) add(k, height, kit.maximum_energy, kit.checked_energy);
  }
  return list;
}

}  // namespace

std::vector<PairChoice> evaluate_pairs(const DesignPlan& plan, const DesignTally& tally,
                                       const std::vector<std::optional<double>>& laterals) {
  std::vector<PairChoice> ranking;
  for (std::size_t p = 0; p < plan.pairs.size(); ++p) {
    const DesignPair& pair = plan.pairs[p];
    const PairCounts& counts = tally.pairs[p];
    const CaughtByPair caught(plan, counts);
    const std::uint64_t all = counts.rocks(), none = counts.at(counts.none(), counts.none());
    const bool is_one_first = counts.one_first >= counts.other_first;
    const auto on_one = candidates_on(plan, pair.one), on_other = candidates_on(plan, pair.other);
    struct Combination {
      const Candidate *one, *other;
      std::uint64_t caught;
      double cost;
    };
    std::vector<Combination> combinations;
    for (const Candidate& one : on_one) {
      for (const Candidate& other : on_other) {
        const std::uint64_t by_either = caught.by_one(one.kit_class) + caught.by_other(other.kit_class) -
                                        caught.by_both(one.kit_class, other.kit_class);
        combinations.push_back({&one, &other, by_either, one.cost + other.cost});
      }
    }
    // The cheapest first, and of equal cost the one that catches more; ties keep the order of heights and energies.
    std::ranges::stable_sort(combinations, [](const Combination& a, const Combination& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.caught > b.caught;
    });
    std::optional<std::uint64_t> most;
    for (const auto& [one, other, by_either, cost] : combinations) {
      if (most && by_either <= *most) continue;
      most = by_either;
      PairChoice& choice = ranking.emplace_back();
      choice.pair = p;
      choice.first = is_one_first ? one->kit : other->kit;
      choice.second = is_one_first ? other->kit : one->kit;
      choice.caught = share_of(by_either, all, plan.confidence);
      choice.by_first = is_one_first ? caught.by_one(one->kit_class) : caught.by_other(other->kit_class);
      choice.by_second = by_either - choice.by_first;
      const std::uint64_t met = is_one_first ? caught.by_other(caught.any()) : caught.by_one(caught.any());
      const std::uint64_t met_and_caught =
          is_one_first ? caught.by_both(one->kit_class, caught.any()) : caught.by_both(caught.any(), other->kit_class);
      choice.at_second = met - met_and_caught;
      choice.beside = none;
      choice.suffices = choice.caught && choice.caught->value >= plan.catch_share;
      if (choice.caught) {
        choice.is_sure =
            choice.suffices ? choice.caught->low >= plan.catch_share : choice.caught->high < plan.catch_share;
      }
      choice.cost = cost;
      if (const auto lateral = laterals[choice.first.line]; lateral && pair.distance) {
        choice.needed_overlap = *lateral * *pair.distance;
      }
    }
  }
  std::ranges::stable_sort(ranking, {}, [](const PairChoice& choice) {
    const double missed = choice.caught ? 1 - choice.caught->value : 1;
    return choice.suffices ? std::tuple(0, choice.cost, missed) : std::tuple(1, missed, choice.cost);
  });
  return ranking;
}

}  // namespace talus
