#pragma once
// Tables as rows of structs. A row declares its columns, once,
//
//   static constexpr auto columns() { return std::tuple(key("rock", "number of the rock", &EndpointRow::rock), ...); }
//
// and from that follow the header, what writes a row, what reads it, its numbers for statistics and the reference page.

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "talus/files/csv_reader.hpp"
#include "talus/files/csv_text.hpp"

namespace talus::io {

/// Words name something, keys number it; quantities can be added up.
enum class ColumnKind { word, key, quantity };

/// A column and where in a row its value is; of a vector one of three, by `part`.
template <class Row, class Value>
struct Column {
  std::string_view name, unit, meaning;
  Value Row::*member;
  ColumnKind kind;
  std::size_t part = 0;

  /// The value in a row, which may be const.
  template <class AnyRow>
  [[nodiscard]] constexpr auto& in(AnyRow& row) const {
    if constexpr (std::same_as<Value, std::array<double, 3>>) {
      return (row.*member)[part];
    } else {
      return row.*member;
    }
  }
};

template <class Row, class Value>
[[nodiscard]] constexpr auto word(std::string_view name, std::string_view meaning, Value Row::*member) {
  return Column<Row, Value>{name, "", meaning, member, ColumnKind::word};
}
template <class Row>
[[nodiscard]] constexpr auto key(std::string_view name, std::string_view meaning, std::uint64_t Row::*member) {
  return Column<Row, std::uint64_t>{name, "", meaning, member, ColumnKind::key};
}
template <class Row, class Value>
[[nodiscard]] constexpr auto quantity(std::string_view name, std::string_view unit, std::string_view meaning,
                                      Value Row::*member, std::size_t part = 0) {
  return Column<Row, Value>{name, unit, meaning, member, ColumnKind::quantity, part};
}

template <class Row>
concept TableRow = requires {
  Row::columns();
};

template <TableRow Row>
inline constexpr std::size_t column_count = std::tuple_size_v<decltype(Row::columns())>;

template <TableRow Row>
inline constexpr std::array<std::string_view, column_count<Row>> column_names =
    std::apply([](const auto&... column) { return std::array<std::string_view, sizeof...(column)>{column.name...}; },
               Row::columns());

/// The place of a member's column, of a vector's first one, while compiling.
template <TableRow Row, class Value>
[[nodiscard]] consteval std::size_t place_of(Value Row::*member) {
  std::size_t place = column_count<Row>, at = 0;
  const auto look = [&](const auto& column) {
    if constexpr (std::same_as<decltype(column.member), Value Row::*>) {
      if (column.member == member && place == column_count<Row>) place = at;
    }
    ++at;
  };
  std::apply([&](const auto&... column) { (look(column), ...); }, Row::columns());
  if (place == column_count<Row>) throw "no such column";  // refused while compiling
  return place;
}

/// Calls visit(column) for each, in their order.
template <TableRow Row, class Visit>
void for_columns(Visit&& visit) {
  std::apply([&](const auto&... column) { (visit(column), ...); }, Row::columns());
}

/// The first line of the table.
template <TableRow Row>
[[nodiscard]] std::string header_of() {
  std::string text;
  CsvRow row(text);
  for_columns<Row>([&](const auto& column) { row << column.name; });
  row.end();
  return text;
}

/// Values of an enum as words in a table: specialised with `values`, all of them, and `fault`, what a word is that
/// stands for none.
template <class Enum>
struct Words;

/// Writes a value as it stands in a table.
template <class Value>
void put_cell(CsvRow& row, const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    row << name(value);
  } else if constexpr (std::same_as<Value, std::string>) {
    row << std::string_view(value);
  } else {
    row << value;
  }
}

/// Adds a row to the text of a table; `memory` (may be null) of the rows before.
template <TableRow Row>
void append_row(std::string& text, const Row& row, CsvMemory* memory = nullptr) {
  CsvRow out(text, memory);
  std::apply([&](const auto&... column) { (put_cell(out, column.in(row)), ...); }, Row::columns());
  out.end();
}

/// The values of a row as texts, column by column.
template <TableRow Row>
[[nodiscard]] std::vector<std::string> texts_of(const Row& row) {
  std::vector<std::string> texts;
  for_columns<Row>([&](const auto& column) {
    const auto& value = column.in(row);
    if constexpr (std::same_as<std::remove_cvref_t<decltype(value)>, std::string>) {
      texts.push_back(value);
    } else {
      CsvRow cell(texts.emplace_back());
      put_cell(cell, value);
      cell.end();
      texts.back().pop_back();  // the row's end
    }
  });
  return texts;
}

/// Goes through a table row by row; values are read when they are asked for. Refuses what CsvReader does.
template <TableRow Row>
class TableReader {
 public:
  explicit TableReader(const std::filesystem::path& file) : csv_(file, column_names<Row>) {}

  [[nodiscard]] bool next() { return csv_.next(); }
  [[nodiscard]] const CsvReader& csv() const { return csv_; }
  [[nodiscard]] CsvReader& csv() { return csv_; }

  /// A value of the current row; texts as views that hold until the next one.
  template <auto member>
  [[nodiscard]] auto get() const {
    constexpr std::size_t place = place_of(member);
    using Value = std::remove_cvref_t<decltype(std::declval<Row>().*member)>;
    if constexpr (std::same_as<Value, std::array<double, 3>>) {
      return Value{csv_.number(place), csv_.number(place + 1), csv_.number(place + 2)};
    } else {
      return cell<Value>(place);
    }
  }
  /// These values of the current row.
  template <auto... members>
  [[nodiscard]] Row part() const {
    Row row;
    ((row.*members = get<members>()), ...);
    return row;
  }
  /// All of them.
  [[nodiscard]] Row whole() const {
    Row row;
    std::size_t place = 0;
    for_columns<Row>([&](const auto& column) {
      auto& value = column.in(row);
      value = cell<std::remove_cvref_t<decltype(value)>>(place++);
    });
    return row;
  }

 private:
  template <class Value>
  [[nodiscard]] auto cell(std::size_t place) const {
    if constexpr (std::same_as<Value, std::string>) {
      return csv_.text(place);
    } else if constexpr (std::same_as<Value, double>) {
      return csv_.number(place);
    } else if constexpr (std::is_enum_v<Value>) {
      return word_in<Value>(place);
    } else {
      static_assert(std::same_as<Value, std::uint64_t>, "a kind of column that is not known");
      return static_cast<std::uint64_t>(csv_.whole_number(place));
    }
  }
  template <class Enum>
  [[nodiscard]] Enum word_in(std::size_t place) const {
    const std::string_view text = csv_.text(place);
    for (const Enum value : Words<Enum>::values) {
      if (text == name(value)) return value;
    }
    std::string known;
    for (const Enum value : Words<Enum>::values) known += (known.empty() ? "" : ", ") + std::string(name(value));
    csv_.refuse(std::string(column_names<Row>[place]), "\"" + std::string(text) + "\" " + Words<Enum>::fault,
                "expected one of " + known);
  }

  CsvReader csv_;
};

}  // namespace talus::io
