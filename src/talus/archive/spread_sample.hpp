#pragma once
// A sample of rocks that is spread evenly over their numbers. It depends neither on the order in which they come nor on
// their total number.

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace talus {

/// Keeps the items whose rock numbers come first in the golden-ratio sequence, as many as the limits allow. The
/// multiples of the golden ratio modulo 1 fall into any range of rocks in proportion to its length (the three-distance
/// theorem, Sos 1958). So neither a long line of releases nor a seeder with few rocks is shown out of proportion. Rock
/// 0 is always kept, and so is at least one item.
template <class Item>
class SpreadSample {
 public:
  SpreadSample(std::size_t most_items, std::size_t most_weight) : most_items_(most_items), most_weight_(most_weight) {}

  /// Whether an item of this rock can still be kept, so that others need not be built.
  [[nodiscard]] bool wants(std::uint64_t rock) const { return !closed_ || place(rock) < limit_; }

  /// `weight` counts towards `most_weight`; items of one rock are kept all together or not at all.
  void add(std::uint64_t rock, std::size_t weight, Item item) {
    if (!wants(rock)) return;
    kept_.emplace(place(rock), Entry{rock, weight, std::move(item)});
    weight_ += weight;
    while ((kept_.size() > most_items_ || weight_ > most_weight_) && kept_.begin()->first != kept_.rbegin()->first) {
      // A refused item stays refused, and so do all with a later place: the result is independent of the order of
      // arrival.
      limit_ = kept_.rbegin()->first;
      closed_ = true;
      while (kept_.rbegin()->first == limit_) {
        weight_ -= kept_.rbegin()->second.weight;
        kept_.erase(std::prev(kept_.end()));
      }
    }
  }

  /// The kept items in the order of rock numbers; items of one rock in the order of arrival.
  [[nodiscard]] std::vector<Item> take() {
    std::multimap<std::uint64_t, Item> by_rock;
    for (auto& [key, entry] : kept_) by_rock.emplace(entry.rock, std::move(entry.item));
    std::vector<Item> items;
    items.reserve(by_rock.size());
    for (auto& [rock, item] : by_rock) items.push_back(std::move(item));
    return items;
  }

 private:
  struct Entry {
    std::uint64_t rock;
    std::size_t weight;
    Item item;
  };
  // 2^64 divided by the golden ratio, to the nearest odd number: Knuth, The Art of Computer Programming 3, section 6.4.
  [[nodiscard]] static std::uint64_t place(std::uint64_t rock) { return rock * 0x9E3779B97F4A7C15u; }

  std::size_t most_items_, most_weight_;
  std::multimap<std::uint64_t, Entry> kept_;  // by place
  std::size_t weight_ = 0;
  std::uint64_t limit_ = 0;  // places from here on are refused once it is closed
  bool closed_ = false;
};

}  // namespace talus
