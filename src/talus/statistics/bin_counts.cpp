#include "talus/statistics/bin_counts.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

constexpr std::uint32_t low_bits = 0x55555555;  // of the 16 digits of a word

std::uint32_t digit_in(std::uint32_t word, std::uint32_t k) { return word >> 2 * k & 3; }

/// The sum of a word's digits.
std::uint32_t sum_of(std::uint32_t word) {
  const std::uint32_t pairs = (word & 0x33333333) + (word >> 2 & 0x33333333);
  return (((pairs + (pairs >> 4)) & 0x0F0F0F0F) * 0x01010101) >> 24;
}

constexpr std::uint32_t place_of(std::uint32_t pending) { return pending >> 19; }

}  // namespace

auto BinCounts::layout(const std::uint32_t* words) -> Layout {
  Layout layout;
  std::uint32_t rows = 0;
  for (std::uint32_t which = 0; which < most_quantities; ++which) {
    layout.digits[which] = words[0] >> 8 * which & 0xFF;
    for (std::uint32_t digit = 0; digit < layout.digits[which]; ++digit, ++rows) {
      const std::uint32_t row = words[1 + rows / 2] >> 16 * (rows % 2);
      layout.rows[which][digit] = {row & 0xFF, row >> 8 & 0xFF};
      layout.size += row >> 8 & 0xFF;
    }
  }
  layout.head = 1 + (rows + 1) / 2;
  layout.size += layout.head;
  return layout;
}

std::uint32_t BinCounts::size_of(const std::uint32_t* words) {
  std::uint32_t rows = 0, size = 0;
  for (std::uint32_t which = 0; which < most_quantities; ++which) rows += words[0] >> 8 * which & 0xFF;
  for (std::uint32_t row = 0; row < rows; ++row) size += words[1 + row / 2] >> (16 * (row % 2) + 8) & 0xFF;
  return 1 + (rows + 1) / 2 + size;
}

BinCounts::Adder::Adder(BinCounts& counts, std::uint32_t place) : counts_(counts), place_(place) {
  if (counts.first_[place] == nowhere) return;
  std::uint32_t* const words = counts.words_.at(counts.first_[place]);
  const std::uint32_t digits = words[0];
  std::uint32_t number = 0;
  for (std::uint32_t which = 0; which < most_quantities; ++which) number += digits >> 8 * which & 0xFF;
  std::uint32_t* next = words + 1 + (number + 1) / 2;
  number = 0;
  for (std::uint32_t which = 0; which < counts.quantities_; ++which) {
    digits_[which] = digits >> 8 * which & 0xFF;
    for (std::uint32_t digit = 0; digit < digits_[which]; ++digit, ++number) {
      const std::uint32_t row = words[1 + number / 2] >> 16 * (number % 2);
      const std::uint32_t length = row >> 8 & 0xFF;
      rows_[which][digit] = {next, row & 0xFF, length};
      next += length;
    }
  }
}

/// The digits of one quantity at one place, in rows that share their first and last word.
class BinCounts::Frame {
 public:
  void begin(std::uint32_t first, std::uint32_t end) {
    first_ = first;
    end_ = end;
    digits_ = 0;
  }
  void put(std::uint32_t digit, const Row& row, const std::uint32_t* words) {
    ensure(digit);
    used_[digit] = row;
    std::copy_n(words, row.length, words_[digit].begin() + row.first);
  }
  void add(std::uint32_t digit, std::uint32_t bin) {
    const std::uint32_t word = bin / bins_a_word, shift = bin % bins_a_word * 2;
    // A count that needs this digit also needs the lower ones.
    for (std::uint32_t below = 0; below < digit; ++below) extend_to(below, word);
    for (; digit < most_digits; ++digit) {
      extend_to(digit, word);
      std::uint32_t& there = words_[digit][word];
      if ((there >> shift & 3) != 3) {
        there += 1U << shift;
        return;
      }
      there &= ~(3U << shift);
    }
  }
  [[nodiscard]] std::uint32_t digits() const { return digits_; }
  [[nodiscard]] const Row& row(std::uint32_t digit) const { return used_[digit]; }
  [[nodiscard]] const std::uint32_t* words(std::uint32_t digit) const {
    return words_[digit].data() + used_[digit].first;
  }

 private:
  void extend_to(std::uint32_t digit, std::uint32_t word) {
    ensure(digit);
    Row& row = used_[digit];
    if (row.length == 0) row.first = word;
    const std::uint32_t end = std::max(row.end(), word + 1);
    row.first = std::min(row.first, word);
    row.length = end - row.first;
  }
  void ensure(std::uint32_t digit) {
    for (; digits_ <= digit; ++digits_) {
      std::fill(words_[digits_].begin() + first_, words_[digits_].begin() + end_, 0);
      used_[digits_] = {};
    }
  }

  std::uint32_t first_ = 0, end_ = 0, digits_ = 0;
  std::array<Row, most_digits> used_;
  std::array<std::array<std::uint32_t, most_words>, most_digits> words_;
};

void BinCounts::rebuild(const std::uint32_t* words, std::span<const std::uint32_t> pending,
                        std::vector<std::uint32_t>& out) {
  thread_local std::array<Frame, most_quantities> frames;
  const Layout old = layout(words);
  const std::uint32_t* next = words + old.head;
  auto more = pending.begin();
  std::uint32_t rows = 0;
  for (std::uint32_t which = 0; which < most_quantities; ++which) {
    auto end = more;
    // The lowest digit has the longest row.
    std::uint32_t first = most_words, last = 0;
    if (old.digits[which] > 0) {
      first = old.rows[which][0].first;
      last = old.rows[which][0].end();
    }
    for (; end != pending.end() && (*end >> 17 & 3) == which; ++end) {
      const std::uint32_t word = (*end & 0xFFF) / bins_a_word;
      first = std::min(first, word);
      last = std::max(last, word + 1);
    }
    Frame& frame = frames[which];
    frame.begin(first, last);
    for (std::uint32_t digit = 0; digit < old.digits[which]; ++digit) {
      frame.put(digit, old.rows[which][digit], next);
      next += old.rows[which][digit].length;
    }
    for (; more != end; ++more) frame.add(*more >> 12 & 0x1F, *more & 0xFFF);
    rows += frame.digits();
  }
  const std::size_t head = out.size();
  out.resize(head + 1 + (rows + 1) / 2);
  rows = 0;
  for (std::uint32_t which = 0; which < most_quantities; ++which) {
    const Frame& frame = frames[which];
    out[head] |= frame.digits() << 8 * which;
    for (std::uint32_t digit = 0; digit < frame.digits(); ++digit, ++rows) {
      const Row& row = frame.row(digit);
      out[head + 1 + rows / 2] |= (row.first | row.length << 8) << 16 * (rows % 2);
      out.insert(out.end(), frame.words(digit), frame.words(digit) + row.length);
    }
  }
}

std::uint32_t BinCounts::new_place() {
  TALUS_PROMISE(first_.size() < most_places, "a place is numbered with 10 bits");
  first_.push_back(nowhere);
  return places() - 1;
}

std::uint32_t BinCounts::Pages::add(std::span<const std::uint32_t> words) {
  const auto size = static_cast<std::uint32_t>(words.size());
  if (size > page_words - used_) {
    // A place that needs more than a page gets a page of its size.
    const std::uint32_t room = std::max(page_words, size);
    pages_.push_back(std::make_unique_for_overwrite<std::uint32_t[]>(room));
    words_ += room;
    used_ = 0;
  }
  std::copy(words.begin(), words.end(), pages_.back().get() + used_);
  const auto place = static_cast<std::uint32_t>((pages_.size() - 1) * page_words + used_);
  used_ = std::min(page_words, used_ + size);
  return place;
}

/// By place, quantity, digit and bin: places are counted, for there are many of them with few increments each.
void BinCounts::sort_pending() {
  std::array<std::uint32_t, most_places + 1> ends{};
  for (const std::uint32_t increment : pending_) ++ends[place_of(increment) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  thread_local std::vector<std::uint32_t> sorted;
  sorted.resize(pending_.size());
  for (const std::uint32_t increment : pending_) sorted[ends[place_of(increment)]++] = increment;
  std::uint32_t first = 0;
  for (std::uint32_t place = 0; place < places(); ++place) {
    std::sort(sorted.begin() + first, sorted.begin() + ends[place]);
    first = ends[place];
  }
  pending_.swap(sorted);
}

void BinCounts::settle() {
  if (pending_.empty()) return;
  sort_pending();
  thread_local std::vector<std::uint32_t> rebuilt;
  Pages words;
  used_ = 0;
  const std::span<const std::uint32_t> pending(pending_);
  std::size_t next = 0;
  for (std::uint32_t place = 0; place < places(); ++place) {
    const std::size_t first = next;
    while (next < pending.size() && place_of(pending[next]) == place) ++next;
    if (next > first) {
      rebuilt.clear();
      rebuild(words_of(place), pending.subspan(first, next - first), rebuilt);
    } else if (first_[place] == nowhere) {
      continue;
    }
    const auto all = next > first ? std::span<const std::uint32_t>(rebuilt) : all_words_of(place);
    first_[place] = words.add(all);
    used_ += all.size();
  }
  words_ = std::move(words);
  pending_ = std::vector<std::uint32_t>();
}

template <class Take>
void BinCounts::for_each_digit(const std::uint32_t* words, Take&& take) {
  const Layout at = layout(words);
  const std::uint32_t* next = words + at.head;
  for (std::uint32_t which = 0; which < most_quantities; ++which) {
    for (std::uint32_t digit = 0; digit < at.digits[which]; ++digit) {
      const Row& row = at.rows[which][digit];
      for (std::uint32_t k = 0; k < row.length; ++k, ++next) {
        for (std::uint32_t left = *next; left != 0;) {
          const auto bin = static_cast<std::uint32_t>(std::countr_zero(left)) / 2;
          take(which, digit, (row.first + k) * bins_a_word + bin, digit_in(left, bin));
          left &= ~(3U << 2 * bin);
        }
      }
    }
  }
}

void BinCounts::merge(std::uint32_t place, const std::uint32_t* words) {
  for_each_digit(words, [&](std::uint32_t which, std::uint32_t digit, std::uint32_t bin, std::uint32_t value) {
    for (; value > 0; --value) add_pending(place, which, digit, bin);
  });
}

void BinCounts::merge(std::uint32_t place, const BinCounts& other, std::uint32_t other_place) {
  TALUS_PROMISE(other.pending_.empty(), "only settled counts can be merged");
  merge(place, other.words_of(other_place));
}

/// The rows of one quantity at one place, read from its greatest value down.
class BinCounts::Descent {
 public:
  Descent(const std::uint32_t* words, std::uint32_t which) {
    std::uint32_t before = 0, rows = 0;
    for (std::uint32_t k = 0; k < most_quantities; ++k) {
      const std::uint32_t digits = words[0] >> 8 * k & 0xFF;
      if (k < which) before += digits;
      rows += digits;
    }
    digits_ = words[0] >> 8 * which & 0xFF;
    const std::uint32_t* next = words + 1 + (rows + 1) / 2;
    for (std::uint32_t row = 0; row < before + digits_; ++row) {
      const std::uint32_t place = words[1 + row / 2] >> 16 * (row % 2), length = place >> 8 & 0xFF;
      if (row >= before) rows_[row - before] = {next, place & 0xFF, length};
      next += length;
    }
    if (digits_ > 0) word_ = rows_[0].first + rows_[0].length;
  }

  /// The value that this many values are above; 0 if there are no more. Must be asked for in ascending order.
  [[nodiscard]] double value_below(std::uint64_t above) {
    while (above >= above_ + here_) {
      if (digits_ == 0 || word_ == rows_[0].first) return 0;
      above_ += here_;
      --word_;
      here_ = 0;
      for (std::uint32_t digit = 0; digit < digits_; ++digit) here_ += std::uint64_t{sum_of(at(digit))} << 2 * digit;
    }
    std::uint32_t used = 0;  // the low bit of each bin that has values
    for (std::uint32_t digit = 0; digit < digits_; ++digit) used |= at(digit) | at(digit) >> 1;
    used &= low_bits;
    std::uint32_t bin = 0;
    for (std::uint64_t left = above - above_ + 1; left > 0; used &= ~(1U << 2 * bin)) {
      bin = (31 - static_cast<std::uint32_t>(std::countl_zero(used))) / 2;
      left -= std::min(left, in_bin(bin));
    }
    return log_bins::middle_of(word_ * bins_a_word + bin);
  }

 private:
  struct Placed {
    const std::uint32_t* words;
    std::uint32_t first, length;
  };
  [[nodiscard]] std::uint32_t at(std::uint32_t digit) const {
    const std::uint32_t k = word_ - rows_[digit].first;
    return k < rows_[digit].length ? rows_[digit].words[k] : 0;
  }
  [[nodiscard]] std::uint64_t in_bin(std::uint32_t bin) const {
    std::uint64_t values = 0;
    for (std::uint32_t digit = 0; digit < digits_; ++digit) {
      values += std::uint64_t{digit_in(at(digit), bin)} << 2 * digit;
    }
    return values;
  }

  std::uint32_t digits_ = 0;
  std::array<Placed, most_digits> rows_;  // only those of `digits_` are set
  std::uint32_t word_ = 0;                // the present one, numbered as in Row
  std::uint64_t above_ = 0, here_ = 0;    // values above it, and in it
};

void BinCounts::quantiles(std::uint32_t place, std::uint32_t which, std::uint64_t count,
                          std::span<const double> probabilities, std::span<double> out) const {
  TALUS_PROMISE(pending_.empty(), "only settled counts have quantiles");
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const auto [rank, fraction] = quantile_place(probabilities[i], count);
    Descent from_top(words_of(place), which);
    const double high = fraction == 0 ? 0 : from_top.value_below(count - 2 - rank);
    const double low = from_top.value_below(count - 1 - rank);
    out[i] = fraction == 0 ? low : between(low, high, fraction);
  }
}

void BinCounts::save(std::uint32_t place, ByteWriter& out) const {
  TALUS_PROMISE(pending_.empty(), "only settled counts can be saved");
  const auto words = all_words_of(place);
  out.put(static_cast<std::uint32_t>(words.size()));
  out.numbers(words);
}

auto BinCounts::merge_saved(std::uint32_t place, ByteReader& in) -> std::array<std::uint64_t, most_quantities> {
  constexpr const char* damaged = "counts in bins are damaged";
  const auto size = in.get<std::uint32_t>();
  expect_bytes(size > 0 && size <= in.left() / sizeof(std::uint32_t), damaged);
  std::vector<std::uint32_t> words(size);
  in.numbers(std::span(words));
  std::uint32_t rows = 0;
  for (std::uint32_t which = 0; which < most_quantities; ++which) {
    const std::uint32_t digits = words[0] >> 8 * which & 0xFF;
    expect_bytes(digits <= most_digits && (digits == 0 || which < quantities_), damaged);
    rows += digits;
  }
  expect_bytes(size >= 1 + (rows + 1) / 2, damaged);
  const Layout at = layout(words.data());
  expect_bytes(at.size == size, damaged);
  for (std::uint32_t which = 0; which < most_quantities; ++which) {
    for (std::uint32_t digit = 0; digit < at.digits[which]; ++digit) {
      const Row &row = at.rows[which][digit], &below = at.rows[which][digit == 0 ? 0 : digit - 1];
      expect_bytes(row.length > 0 && row.end() <= most_words, damaged);
      expect_bytes(row.first >= below.first && row.end() <= below.end(), damaged);
    }
  }
  std::array<std::uint64_t, most_quantities> counts{};
  for_each_digit(words.data(), [&](std::uint32_t which, std::uint32_t digit, std::uint32_t bin, std::uint32_t value) {
    expect_bytes(bin < log_bins::count && digit < 30, damaged);
    counts[which] += std::uint64_t{value} << 2 * digit;
  });
  merge(place, words.data());
  settle_if_due();
  return counts;
}

bool BinCounts::are_same(const BinCounts& a, std::uint32_t place_a, const BinCounts& b, std::uint32_t place_b) {
  TALUS_PROMISE(a.pending_.empty() && b.pending_.empty(), "only settled counts can be compared");
  const auto left = a.all_words_of(place_a), right = b.all_words_of(place_b);
  return std::equal(left.begin(), left.end(), right.begin(), right.end());
}

}  // namespace talus
