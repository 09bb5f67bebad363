#include "talus/statistics/quantile_sketch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

constexpr int dropped_bits = 42;  // of the 52 of the fraction
constexpr double least_magnitude = 0x1p-40;
constexpr double most_magnitude = 0x1p80;

// Limit of saved sketches: more than any campaign has, and small enough that sums of a few of them cannot overflow.
constexpr std::uint64_t most_values = std::uint64_t{1} << 60;
constexpr const char* damaged = "the counts behind quantiles are damaged";

std::uint32_t bin_of(double magnitude) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(std::min(magnitude, most_magnitude)) >> dropped_bits);
}

double middle_of(std::uint32_t bin) {
  return std::bit_cast<double>(std::uint64_t{bin} << dropped_bits | std::uint64_t{1} << (dropped_bits - 1));
}

}  // namespace

void QuantileSketch::Bins::add(std::uint32_t bin, std::uint64_t count) {
  constexpr std::uint32_t room = 1024;  // a factor of two, so that growing is rare
  if (counts.empty()) {
    first = bin - bin % room;
    counts.resize(room);
  } else if (bin < first) {
    const std::uint32_t new_first = bin - bin % room;
    counts.insert(counts.begin(), first - new_first, 0);
    first = new_first;
  } else if (bin - first >= counts.size()) {
    counts.resize(bin - first + room - bin % room);
  }
  counts[bin - first] += count;
}

void QuantileSketch::count_in_bins(double x) {
  const double distance = x - origin_, magnitude = std::abs(distance);
  if (magnitude < least_magnitude) {
    ++zeros_;
  } else {
    (distance > 0 ? positive_ : negative_).add(bin_of(magnitude), 1);
  }
}

void QuantileSketch::fill_bins() {
  for (const double x : values_) count_in_bins(x);
  values_ = {};
  is_binned_ = true;
}

void QuantileSketch::put(double x) {
  if (is_binned_) {
    count_in_bins(x);
  } else {
    values_.push_back(x);
    if (!is_exact_ && values_.size() > most_waiting) fill_bins();
  }
}

QuantileSketch QuantileSketch::binned() const {
  QuantileSketch copy = *this;
  copy.fill_bins();
  return copy;
}

void QuantileSketch::add(double x) {
  TALUS_PROMISE(std::isfinite(x), "only finite numbers can be ranked");
  x += 0.0;  // turns -0 into 0: extremes and order must not depend on which came first
  minimum_ = count_ == 0 ? x : std::min(minimum_, x);
  maximum_ = count_ == 0 ? x : std::max(maximum_, x);
  ++count_;
  is_exact_ = is_exact_ && count_ <= most_exact;
  put(x);
}

void QuantileSketch::merge(const QuantileSketch& other) {
  TALUS_PROMISE(planned_ == other.planned_, "sketches must be planned for the same number of values");
  TALUS_PROMISE(origin_ == other.origin_, "sketches must have the same origin");
  if (other.count_ == 0) return;
  minimum_ = count_ == 0 ? other.minimum_ : std::min(minimum_, other.minimum_);
  maximum_ = count_ == 0 ? other.maximum_ : std::max(maximum_, other.maximum_);
  count_ += other.count_;
  is_exact_ = is_exact_ && count_ <= most_exact;
  for (const double x : other.values_) put(x);
  if (!other.is_binned_) return;
  if (!is_binned_) fill_bins();
  for (const auto& [mine, theirs] :
       {std::pair{&positive_, &other.positive_}, std::pair{&negative_, &other.negative_}}) {
    for (std::uint32_t i = 0; i < theirs->counts.size(); ++i) {
      if (theirs->counts[i] > 0) mine->add(theirs->first + i, theirs->counts[i]);
    }
  }
  zeros_ += other.zeros_;
}

void QuantileSketch::Bins::save(ByteWriter& out) const {
  out.count(counts.size() - static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 0U)));
  for (std::uint32_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    out.put(first + i);
    out.put(counts[i]);
  }
}

std::uint64_t QuantileSketch::Bins::read(ByteReader& in) {
  std::uint64_t values = 0;
  std::optional<std::uint32_t> before;
  for (std::size_t left = in.count(sizeof(std::uint32_t) + sizeof(std::uint64_t)); left > 0; --left) {
    const auto bin = in.get<std::uint32_t>();
    const auto count = in.get<std::uint64_t>();
    expect_bytes((!before || bin > *before) && bin >= bin_of(least_magnitude) && bin <= bin_of(most_magnitude),
                 damaged);
    expect_bytes(count > 0 && count <= most_values - values, damaged);
    add(bin, count);
    values += count;
    before = bin;
  }
  return values;
}

void QuantileSketch::save(ByteWriter& out) const {
  out.put(planned_);
  out.put(count_);
  if (count_ == 0) return;
  out.put(minimum_);
  out.put(maximum_);
  if (is_exact_) {
    std::vector<double> sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    out.numbers(std::span<const double>(sorted));
    return;
  }
  if (!is_binned_) {
    const QuantileSketch copy = binned();
    copy.negative_.save(out);
    out.put(copy.zeros_);
    copy.positive_.save(out);
    return;
  }
  negative_.save(out);
  out.put(zeros_);
  positive_.save(out);
}

void QuantileSketch::merge_saved(ByteReader& in) {
  QuantileSketch saved(in.get<std::uint64_t>(), origin_);
  expect_bytes(saved.planned_ == planned_, "quantiles are of a run of another number of rocks");
  saved.count_ = in.get<std::uint64_t>();
  expect_bytes(saved.count_ <= most_values, damaged);
  if (saved.count_ == 0) return;
  saved.minimum_ = in.get<double>();
  saved.maximum_ = in.get<double>();
  expect_bytes(std::isfinite(saved.minimum_) && std::isfinite(saved.maximum_) && saved.minimum_ <= saved.maximum_,
               damaged);
  saved.is_exact_ = saved.is_exact_ && saved.count_ <= most_exact;
  if (saved.is_exact_) {
    expect_bytes(saved.count_ <= in.left() / sizeof(double), damaged);
    saved.values_.resize(saved.count_);
    in.numbers(std::span(saved.values_));
    expect_bytes(saved.values_.front() == saved.minimum_ && saved.values_.back() == saved.maximum_, damaged);
    for (std::size_t k = 1; k < saved.values_.size(); ++k) {
      expect_bytes(saved.values_[k - 1] <= saved.values_[k], damaged);  // false if either is NaN
    }
  } else {
    saved.is_binned_ = true;
    const std::uint64_t below = saved.negative_.read(in);
    saved.zeros_ = in.get<std::uint64_t>();
    const std::uint64_t above = saved.positive_.read(in);
    expect_bytes(saved.zeros_ <= most_values && below + saved.zeros_ + above == saved.count_, damaged);
  }
  merge(saved);
}

std::vector<QuantileSketch::Counted> QuantileSketch::ascending() const {
  std::vector<Counted> counted;
  if (is_exact_) {
    std::vector<double> sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    for (const double x : sorted) {
      if (counted.empty() || counted.back().value != x) counted.push_back({x, 0});
      ++counted.back().count;
    }
    return counted;
  }
  if (!is_binned_) return binned().ascending();
  const auto put = [&](double distance, std::uint64_t count) {
    if (count > 0) counted.push_back({std::clamp(origin_ + distance, minimum_, maximum_), count});
  };
  for (std::size_t i = negative_.counts.size(); i-- > 0;) {
    put(-middle_of(negative_.first + static_cast<std::uint32_t>(i)), negative_.counts[i]);
  }
  put(0, zeros_);
  for (std::size_t i = 0; i < positive_.counts.size(); ++i) {
    put(middle_of(positive_.first + static_cast<std::uint32_t>(i)), positive_.counts[i]);
  }
  return counted;
}

std::optional<double> QuantileSketch::quantile(double p) const {
  if (count_ == 0) return {};
  const auto [rank, fraction] = quantile_place(p, count_);
  if (is_exact_) {
    std::vector<double> values = values_;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), at, values.end());
    return fraction > 0 ? between(*at, *std::min_element(at + 1, values.end()), fraction) : *at;
  }
  const std::vector<Counted> counted = ascending();
  const auto value_at = [&](std::uint64_t wanted) {
    if (wanted == 0) return minimum_;
    if (wanted == count_ - 1) return maximum_;
    for (const Counted& each : counted) {
      if (wanted < each.count) return each.value;
      wanted -= each.count;
    }
    return maximum_;
  };
  const double low = value_at(rank);
  return fraction > 0 ? between(low, value_at(rank + 1), fraction) : low;
}

}  // namespace talus
