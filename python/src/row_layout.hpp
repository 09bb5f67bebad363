#pragma once
// Rows of tables as fixed-size records: the elements of NumPy's structured arrays. The columns are those that the row
// declares (files/csv_table.hpp): numbers as float64 or int64, words as text of fixed width, empty cells as NaN, or -1
// for whole numbers.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/files/csv_table.hpp"

namespace talus::python {

/// The Unicode code points of a text in UTF-8.
[[nodiscard]] std::u32string code_points(std::string_view text);
[[nodiscard]] std::string utf8(std::u32string_view text);

static_assert(std::endian::native == std::endian::little);

struct RowLayout {
  struct Field {
    std::string name, format;  // of a NumPy data type
    std::size_t offset = 0, width = 0;
  };
  std::vector<Field> fields;
  std::size_t size = 0;  // of a row [bytes]

  void add(std::string name, std::string format, std::size_t width);
};

/// How many code points a text column must hold, by its name.
using TextWidth = std::function<std::size_t(std::string_view column)>;

/// The longest of some texts [code points]. Throws BadInput if it is longer than a table in memory can hold.
[[nodiscard]] std::size_t width_of(std::span<const std::string> texts);

template <class Value>
inline constexpr bool is_text = std::is_same_v<Value, std::string> || std::is_enum_v<Value>;

template <class Enum>
[[nodiscard]] std::size_t width_of_words() {
  std::size_t width = 1;
  for (const Enum value : Words<Enum>::values) width = std::max(width, std::string_view(name(value)).size());
  return width;
}

/// Calls visit(value, format) for each column of a row, and each value of its family. `row` may be const.
template <class Row, class AnyRow, class Visit>
void for_values(AnyRow& row, Visit&& visit) {
  for_columns<Row>([&](const auto& column) {
    if constexpr (is_family<std::remove_cvref_t<decltype(column)>>) {
      for (auto& value : row.*column.member) visit(value);
    } else {
      visit(column.in(row));
    }
  });
}

template <TableRow Row>
[[nodiscard]] RowLayout layout_of(const TextWidth& text_width, std::span<const std::string> of_family = {}) {
  RowLayout layout;
  const auto add = [&]<class Value>(std::string_view name, const Value*) {
    if constexpr (std::is_enum_v<Value>) {
      const std::size_t width = width_of_words<Value>();
      layout.add(std::string(name), "<U" + std::to_string(width), width * sizeof(char32_t));
    } else if constexpr (std::is_same_v<Value, std::string>) {
      const std::size_t width = std::max<std::size_t>(1, text_width(name));
      layout.add(std::string(name), "<U" + std::to_string(width), width * sizeof(char32_t));
    } else if constexpr (std::is_same_v<Value, std::uint64_t> || std::is_same_v<Value, std::optional<std::uint64_t>>) {
      layout.add(std::string(name), "<i8", sizeof(std::int64_t));
    } else {
      static_assert(std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>);
      layout.add(std::string(name), "<f8", sizeof(double));
    }
  };
  for_columns<Row>([&](const auto& column) {
    using Given = std::remove_cvref_t<decltype(column)>;
    if constexpr (is_family<Given>) {
      for (const std::string& name : of_family) add(name, static_cast<const double*>(nullptr));
    } else {
      Row row;
      add(column.name, &std::as_const(column.in(row)));
    }
  });
  // So that numbers stay aligned in the next row.
  layout.size = (layout.size + sizeof(double) - 1) / sizeof(double) * sizeof(double);
  return layout;
}

inline void put_text(std::string_view text, const RowLayout::Field& field, std::byte* place) {
  if (text.size() * sizeof(char32_t) <= field.width &&
      std::none_of(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; })) {
    std::memset(place, 0, field.width);
    for (std::size_t k = 0; k < text.size(); ++k) place[k * sizeof(char32_t)] = static_cast<std::byte>(text[k]);
    return;
  }
  const std::u32string points = code_points(text);
  const std::size_t bytes = std::min(points.size() * sizeof(char32_t), field.width);
  std::memcpy(place, points.data(), bytes);
  std::memset(place + bytes, 0, field.width - bytes);
}

/// Appends a row.
template <TableRow Row>
void pack(const Row& row, const RowLayout& layout, std::vector<std::byte>& out) {
  const std::size_t begin = out.size();
  out.resize(begin + layout.size);
  std::size_t k = 0;
  for_values<Row>(row, [&]<class Value>(const Value& value) {
    const RowLayout::Field& field = layout.fields[k++];
    std::byte* const place = out.data() + begin + field.offset;
    const auto put = [&](const auto& plain) { std::memcpy(place, &plain, sizeof(plain)); };
    if constexpr (std::is_enum_v<Value>) {
      put_text(name(value), field, place);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      put_text(value, field, place);
    } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>>) {
      put(value ? static_cast<std::int64_t>(*value) : std::int64_t{-1});
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      put(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    } else {
      put(value);
    }
  });
}

/// The row at a place. Expects one without a family.
template <TableRow Row>
void unpack(const std::byte* place, const RowLayout& layout, Row& row) {
  std::size_t k = 0;
  for_values<Row>(row, [&]<class Value>(Value& value) {
    const RowLayout::Field& field = layout.fields[k++];
    const std::byte* const at = place + field.offset;
    const auto get = [&]<class Plain>(Plain plain) {
      std::memcpy(&plain, at, sizeof(plain));
      return plain;
    };
    if constexpr (is_text<Value>) {
      std::u32string points(field.width / sizeof(char32_t), U'\0');
      std::memcpy(points.data(), at, field.width);
      points.resize(points.find_last_not_of(U'\0') + 1);
      const std::string text = utf8(points);
      if constexpr (std::is_enum_v<Value>) {
        for (const Value each : Words<Value>::values) {
          if (text == name(each)) value = each;
        }
      } else {
        value = text;
      }
    } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>>) {
      const auto number = get(std::int64_t{});
      value = number < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(number));
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      const auto number = get(double{});
      value = std::isnan(number) ? std::nullopt : std::optional(number);
    } else {
      value = get(Value{});
    }
  });
}

}  // namespace talus::python
