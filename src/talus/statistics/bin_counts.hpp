#pragma once
// Counts of values in bins, for a few quantities at each of many places: their quantiles in little memory.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "talus/core/bytes.hpp"
#include "talus/statistics/log_bins.hpp"

namespace talus {

/// For up to four quantities at each place: how many of its values are in each of the bins of log_bins.hpp. All are
/// integers, so that any split and any order of the values merges to the same counts. Settled counts have the same
/// bytes, too.
///
/// A count is written in base four. For each digit a place keeps a row of bins, two bits a bin: from the first to the
/// last bin whose count needs that digit, in steps of 16 bins. A few hundred values spread over a few dozen bins take
/// 20 to 90 bytes a quantity; a thousand times as many values take four times as much.
class BinCounts {
 public:
  static constexpr std::uint32_t most_quantities = 4, most_places = 1U << 10;

  explicit BinCounts(std::uint32_t quantities = most_quantities) : quantities_(quantities) {}

  /// Returns its zero-based number.
  std::uint32_t new_place();
  [[nodiscard]] std::uint32_t places() const { return static_cast<std::uint32_t>(first_.size()); }

  /// Adds values at one place; valid until the counts are changed in any other way.
  class Adder;
  [[nodiscard]] Adder at(std::uint32_t place);
  /// Adds the counts at a place of `other`, which must be settled, to those at a place here.
  void merge(std::uint32_t place, const BinCounts& other, std::uint32_t other_place);
  /// Makes room for counts that have outgrown their rows. It is due when enough of them wait to make it worthwhile.
  /// Everything below expects settled counts.
  void settle();
  void settle_if_due() {
    if (pending_.size() > few_pending + used_ / 16) settle();
  }

  /// For each probability in [0, 1] the quantile of one of the quantities at a place, by definition 7 (quantile.hpp),
  /// its order statistics within 1 %. `count`, at least 1, is the number of values including those below
  /// log_bins::least, which count as zero; the caller keeps it.
  void quantiles(std::uint32_t place, std::uint32_t which, std::uint64_t count, std::span<const double> probabilities,
                 std::span<double> out) const;

  void save(std::uint32_t place, ByteWriter& out) const;
  /// Adds saved counts to those at a place; returns the number of values of each quantity. Throws BadBytes on anything
  /// else.
  std::array<std::uint64_t, most_quantities> merge_saved(std::uint32_t place, ByteReader& in);
  static constexpr std::size_t least_saved = 2 * sizeof(std::uint32_t);

  [[nodiscard]] std::size_t bytes() const {
    return (words_.words() + first_.capacity() + pending_.capacity()) * sizeof(std::uint32_t);
  }
  /// Whether two places have the same counts; both must be settled.
  [[nodiscard]] static bool are_same(const BinCounts& a, std::uint32_t place_a, const BinCounts& b,
                                     std::uint32_t place_b);

 private:
  static constexpr std::size_t few_pending = 256;
  static constexpr std::uint32_t nowhere = ~0U;
  static constexpr std::uint32_t bins_a_word = 16;
  static constexpr std::uint32_t most_words = (log_bins::count + bins_a_word - 1) / bins_a_word;
  static constexpr std::uint32_t most_digits = 32;  // of a 64-bit number

  /// One digit of one quantity: words from `first` on, numbered as if there were one for every 16 bins.
  struct Row {
    std::uint32_t first, length;
    [[nodiscard]] std::uint32_t end() const { return first + length; }
  };
  struct Layout {
    std::array<std::uint32_t, most_quantities> digits{};
    std::array<std::array<Row, most_digits>, most_quantities> rows;  // only those of `digits` are set
    std::uint32_t head = 0;  // words before the first row's
    std::uint32_t size = 0;  // in words
  };
  class Frame;
  class Descent;

  /// Memory in pages of one size, so that a page that one tile releases can be used by another.
  class Pages {
   public:
    /// Stores the words next to each other; returns where they begin.
    [[nodiscard]] std::uint32_t add(std::span<const std::uint32_t> words);
    [[nodiscard]] const std::uint32_t* at(std::uint32_t place) const {
      return pages_[place / page_words].get() + place % page_words;
    }
    [[nodiscard]] std::uint32_t* at(std::uint32_t place) {
      return pages_[place / page_words].get() + place % page_words;
    }
    [[nodiscard]] std::size_t words() const { return words_; }

   private:
    static constexpr std::uint32_t page_words = 1U << 12;
    std::vector<std::unique_ptr<std::uint32_t[]>> pages_;
    std::size_t words_ = 0;
    std::uint32_t used_ = page_words;  // of the last page
  };

  [[nodiscard]] static Layout layout(const std::uint32_t* words);
  [[nodiscard]] static std::uint32_t size_of(const std::uint32_t* words);
  /// The words of a place; a zero word if no value was added.
  [[nodiscard]] const std::uint32_t* words_of(std::uint32_t place) const {
    static constexpr std::uint32_t none = 0;
    return first_[place] == nowhere ? &none : words_.at(first_[place]);
  }
  [[nodiscard]] std::span<const std::uint32_t> all_words_of(std::uint32_t place) const {
    const std::uint32_t* const words = words_of(place);
    return {words, size_of(words)};
  }
  void add_pending(std::uint32_t place, std::uint32_t which, std::uint32_t digit, std::uint32_t bin) {
    pending_.push_back(place << 19 | which << 17 | digit << 12 | bin);
  }
  void merge(std::uint32_t place, const std::uint32_t* words);
  void sort_pending();
  static void rebuild(const std::uint32_t* words, std::span<const std::uint32_t> pending,
                      std::vector<std::uint32_t>& out);
  /// Calls take(which, digit, bin, value) for every digit above 0.
  template <class Take>
  static void for_each_digit(const std::uint32_t* words, Take&& take);

  std::uint32_t quantities_;
  // The words of a place are next to each other: a word with the number of digits of each quantity, a byte each; for
  // each digit the first word and the length of its row, a byte each; then the rows.
  Pages words_;
  std::size_t used_ = 0;              // words
  std::vector<std::uint32_t> first_;  // of each place, in words_
  // Increments outside their rows: place, quantity, digit and bin in 10, 2, 5 and 12 bits.
  std::vector<std::uint32_t> pending_;
};

class BinCounts::Adder {
 public:
  /// Expects a value of 0 or more.
  void add(std::uint32_t which, float value) {
    if (value < log_bins::least) return;
    const std::uint32_t bin = log_bins::bin_of(value), word = bin / bins_a_word, shift = bin % bins_a_word * 2;
    std::uint32_t digit = 0;
    for (; digit < digits_[which]; ++digit) {
      const Place& row = rows_[which][digit];
      const std::uint32_t k = word - row.first;
      if (k >= row.length) break;
      std::uint32_t& there = row.words[k];
      if ((there >> shift & 3) != 3) {
        there += 1U << shift;
        return;
      }
      there &= ~(3U << shift);
    }
    counts_.add_pending(place_, which, digit, bin);
  }

 private:
  friend class BinCounts;
  struct Place {
    std::uint32_t* words;
    std::uint32_t first, length;
  };
  Adder(BinCounts& counts, std::uint32_t place);

  BinCounts& counts_;
  std::uint32_t place_;
  std::array<std::uint32_t, most_quantities> digits_{};
  std::array<std::array<Place, most_digits>, most_quantities> rows_;  // only those of `digits_` are set
};

inline BinCounts::Adder BinCounts::at(std::uint32_t place) { return {*this, place}; }

}  // namespace talus
