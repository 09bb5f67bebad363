#pragma once
// What must hold of everything that is saved and merged again, whatever it is.

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

/// Merges saved bytes into something, all of them; whether they were taken for what they should be.
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

/// `whole` holds what all `parts` together do; `empty()` makes one that holds nothing. Parts that are saved and merged
/// in any order are the whole, to the last byte.
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

/// Bytes that end too early, anywhere or (where there are very many) at places spread over all, are refused. Bytes of
/// which some bits were turned are refused or taken, and `use` finds its way about what was taken.
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
