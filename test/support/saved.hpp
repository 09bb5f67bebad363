#pragma once
// Checks what is true of everything that can be saved and merged.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "support/dice.hpp"
#include "talus/core/bytes.hpp"

namespace talus::testing_tools {

template <class T>
std::string saved(T&& value) {
  ByteWriter out;
  value.save(out);
  return out.take();
}

/// Merges saved bytes into an object; returns whether all of them were accepted.
template <class T>
bool takes(T& into, std::string_view bytes) {
  try {
    ByteReader in(bytes);
    into.merge_saved(in);
    in.expect_end();
    return true;
  } catch (const BadBytes&) {
    return false;
  }
}

/// `whole` is the sum of all `parts`; `empty()` makes an empty object. Parts that are saved and merged in any order
/// give the whole, to the last byte.
template <class T>
void expect_merged_parts_are_the_whole(Dice& dice, T& whole, std::vector<T>& parts, const std::function<T()>& empty) {
  const std::string expected = saved(whole);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<std::string> waiting;
    for (T& part : parts) waiting.push_back(saved(part));
    T merged = empty();
    while (!waiting.empty()) {
      const std::size_t k = dice.below(waiting.size());
      ASSERT_TRUE(takes(merged, waiting[k]));
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(k));
    }
    EXPECT_EQ(saved(merged), expected);
  }
  T restored = empty();
  ASSERT_TRUE(takes(restored, expected));
  EXPECT_EQ(saved(restored), expected);
  EXPECT_NE(saved(empty()), expected) << "the comparison can fail";
}

/// Truncated bytes are refused, wherever they end (for very many bytes, at places spread over them). Bytes with flipped
/// bits are refused or accepted, and `use` works on what was accepted.
template <class T>
void expect_damage_is_survived(Dice& dice, const std::string& bytes, const std::function<T()>& empty,
                               const std::function<void(T&)>& use) {
  const std::size_t step = bytes.size() / 1500 + 1;
  for (std::size_t size = 0; size < bytes.size(); size += 1 + dice.below(2 * step - 1)) {
    T into = empty();
    ASSERT_FALSE(takes(into, std::string_view(bytes).substr(0, size))) << size << " of " << bytes.size();
  }
  T into = empty();
  EXPECT_FALSE(takes(into, bytes + '\0'));
  int refused = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::string changed = bytes;
    for (std::size_t n = 1 + dice.below(3); n-- > 0;) {
      char& byte = changed[dice.below(changed.size())];
      byte = static_cast<char>(byte ^ (1 << dice.below(8)));
    }
    T damaged = empty();
    if (takes(damaged, changed)) {
      use(damaged);
    } else {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace talus::testing_tools
