#pragma once
// Tables as rows of structs. A row declares its columns once,
//
//   static constexpr auto columns() { return std::tuple(key("rock", "number of the rock", &EndpointRow::rock), ...); }
//
// From that follow the header, what writes a row, what reads it, the columns of numbers for statistics, the tables of
// columns in the documentation and the list of columns for the page.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "talus/files/csv_reader.hpp"
#include "talus/files/csv_text.hpp"

namespace talus {

/// Words and keys identify something; quantities can be averaged.
enum class ColumnKind { word, key, quantity };

/// A column, and where in a row its value is: of a vector the component `part`.
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
/// A whole number that identifies something.
template <class Row, class Value>
[[nodiscard]] constexpr auto key(std::string_view name, std::string_view meaning, Value Row::*member) {
  return Column<Row, Value>{name, "", meaning, member, ColumnKind::key};
}
template <class Row, class Value>
[[nodiscard]] constexpr auto quantity(std::string_view name, std::string_view unit, std::string_view meaning,
                                      Value Row::*member, std::size_t part = 0) {
  return Column<Row, Value>{name, unit, meaning, member, ColumnKind::quantity, part};
}

/// Columns whose number and names depend on the project: percentiles, chosen maps. A row has at most one such family;
/// who writes it gives the names. `Row::family_texts()` describes it for the reference (ColumnText).
using FamilyValues = std::vector<std::optional<double>>;
template <class Row>
struct Family {
  FamilyValues Row::*member;
};
template <class Row>
[[nodiscard]] constexpr auto family(FamilyValues Row::*member) {
  return Family<Row>{member};
}
template <class>
inline constexpr bool is_family = false;
template <class Row>
inline constexpr bool is_family<Family<Row>> = true;

template <class>
inline constexpr bool is_optional = false;
template <class Value>
inline constexpr bool is_optional<std::optional<Value>> = true;

template <class Row>
concept TableRow = requires {
  Row::columns();
};

/// Calls visit(column) for each column, and for the family, in their order.
template <TableRow Row, class Visit>
constexpr void for_columns(Visit&& visit) {
  std::apply([&](const auto&... column) { (visit(column), ...); }, Row::columns());
}

/// How many columns a row has without its family.
template <TableRow Row>
inline constexpr std::size_t column_count = [] {
  std::size_t count = 0;
  for_columns<Row>([&](const auto& column) { count += is_family<std::remove_cvref_t<decltype(column)>> ? 0 : 1; });
  return count;
}();

/// The place of the family among the columns, if there is one.
template <TableRow Row>
inline constexpr std::optional<std::size_t> family_place = [] {
  std::optional<std::size_t> place;
  std::size_t at = 0;
  for_columns<Row>([&](const auto& column) {
    if (is_family<std::remove_cvref_t<decltype(column)>>) place = at;
    ++at;
  });
  return place;
}();

/// The names of the columns without those of the family.
template <TableRow Row>
inline constexpr std::array<std::string_view, column_count<Row>> column_names = [] {
  std::array<std::string_view, column_count<Row>> names;
  std::size_t at = 0;
  for_columns<Row>([&](const auto& column) {
    if constexpr (!is_family<std::remove_cvref_t<decltype(column)>>) names[at++] = column.name;
  });
  return names;
}();

/// How many of the last columns a table may lack: `Row::may_lack`, which are optional.
template <TableRow Row>
inline constexpr std::size_t may_lack = [] {
  if constexpr (requires { Row::may_lack; }) {
    return Row::may_lack;
  } else {
    return std::size_t{0};
  }
}();

/// The place of a member's column in column_names, of a vector's first one.
template <TableRow Row, class Value>
[[nodiscard]] consteval std::size_t place_of(Value Row::*member) {
  std::size_t place = column_count<Row>, at = 0;
  for_columns<Row>([&](const auto& column) {
    using Given = std::remove_cvref_t<decltype(column)>;
    if constexpr (!is_family<Given>) {
      if constexpr (std::same_as<decltype(column.member), Value Row::*>) {
        if (column.member == member && place == column_count<Row>) place = at;
      }
      ++at;
    }
  });
  if (place == column_count<Row>) throw "no such column";  // refused while compiling
  return place;
}

/// The names of all columns, those of the family at their place.
template <TableRow Row>
[[nodiscard]] std::vector<std::string> names_of(std::span<const std::string> of_family = {}) {
  std::vector<std::string> names(column_names<Row>.begin(), column_names<Row>.end());
  if (family_place<Row>)
    names.insert(names.begin() + static_cast<std::ptrdiff_t>(*family_place<Row>), of_family.begin(), of_family.end());
  return names;
}

inline constexpr std::size_t all_columns = static_cast<std::size_t>(-1);

/// The first line of the table, with the first `columns` of its columns.
template <TableRow Row>
[[nodiscard]] std::string header_of(std::span<const std::string> of_family = {}, std::size_t columns = all_columns) {
  std::string text;
  CsvRow row(text);
  std::vector<std::string> names = names_of<Row>(of_family);
  if (names.size() > columns) names.resize(columns);
  for (const std::string& name : names) row << name;
  row.end();
  return text;
}

/// Values of an enum as words in a table: specialised with `values`, all of them, and `fault`, how a message ends about
/// a word that is none of them.
template <class Enum>
struct Words;

/// Writes a value as it is in a table: yes or no, and an empty cell for an optional without a value.
template <class Value>
void put_cell(CsvRow& row, const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    row << name(value);
  } else if constexpr (std::same_as<Value, std::string>) {
    row << std::string_view(value);
  } else if constexpr (std::same_as<Value, bool>) {
    row << (value ? "yes" : "no");
  } else {
    row << value;
  }
}
template <class Value>
void put_cell(CsvRow& row, const std::optional<Value>& value) {
  if (value) {
    put_cell(row, *value);
  } else {
    row << "";
  }
}

/// Adds a row to the text of a table; `memory` (may be null) of the rows before. `columns`: as for header_of().
template <TableRow Row>
void append_row(std::string& text, const Row& row, CsvMemory* memory = nullptr, std::size_t columns = all_columns) {
  CsvRow out(text, memory);
  std::size_t place = 0;
  for_columns<Row>([&](const auto& column) {
    if (place++ >= columns) return;
    if constexpr (is_family<std::remove_cvref_t<decltype(column)>>) {
      for (const std::optional<double>& value : row.*column.member) put_cell(out, value);
    } else {
      put_cell(out, column.in(row));
    }
  });
  out.end();
}

/// The values of a row as texts, column by column; without the last columns that a table may lack if they are empty.
template <TableRow Row>
[[nodiscard]] std::vector<std::string> texts_of(const Row& row) {
  static_assert(!family_place<Row>);
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
  const auto last = texts.end() - static_cast<std::ptrdiff_t>(may_lack<Row>);
  if (std::all_of(last, texts.end(), [](const std::string& text) { return text.empty(); }))
    texts.erase(last, texts.end());
  return texts;
}

/// Reads a table row by row; values are converted when they are asked for. Throws BadInput as CsvReader does.
template <TableRow Row>
class TableReader {
 public:
  /// Expects the columns of the row, and any number of others where it has a family. Those that it may lack are empty
  /// then.
  explicit TableReader(const std::filesystem::path& file)
      : csv_(file, column_names<Row>, family_place<Row>, may_lack<Row>),
        family_size_(family_place<Row> ? csv_.columns().size() - column_count<Row> : 0) {}

  [[nodiscard]] bool next() { return csv_.next(); }
  [[nodiscard]] const CsvReader& csv() const { return csv_; }
  [[nodiscard]] CsvReader& csv() { return csv_; }

  /// The names of the family's columns.
  [[nodiscard]] std::span<const std::string> family_names() const requires(family_place<Row>.has_value()) {
    return csv_.columns().subspan(*family_place<Row>, family_size_);
  }

  /// A value of the current row; texts as views that are valid until the next one.
  template <auto member>
  [[nodiscard]] auto get() const {
    using Value = std::remove_cvref_t<decltype(std::declval<Row>().*member)>;
    if constexpr (std::same_as<Value, FamilyValues>) {
      FamilyValues values(family_size_);
      for (std::size_t k = 0; k < family_size_; ++k) values[k] = cell<std::optional<double>>(*family_place<Row> + k);
      return values;
    } else {
      constexpr std::size_t declared = place_of(member);
      const std::size_t place = declared + (declared < family_place<Row>.value_or(declared + 1) ? 0 : family_size_);
      if constexpr (std::same_as<Value, std::array<double, 3>>) {
        return Value{csv_.number(place), csv_.number(place + 1), csv_.number(place + 2)};
      } else {
        return cell<Value>(place);
      }
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
    static_assert(!family_place<Row>);
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
    } else if constexpr (is_optional<Value>) {
      return csv_.has_value(place) ? Value(cell<typename Value::value_type>(place)) : Value();
    } else if constexpr (std::is_enum_v<Value>) {
      return word_in<Value>(place);
    } else {
      static_assert(std::same_as<Value, std::uint64_t>, "no reader for this type of column");
      return static_cast<std::uint64_t>(csv_.whole_number(place));
    }
  }
  template <class Enum>
  [[nodiscard]] Enum word_in(std::size_t place) const {
    const std::string_view text = csv_.text(place);
    for (const Enum value : Words<Enum>::values) {
      if (text == name(value)) return value;
    }
    std::vector<std::string_view> known;
    for (const Enum value : Words<Enum>::values) known.emplace_back(name(value));
    csv_.refuse_word(place, Words<Enum>::fault, known);
  }

  CsvReader csv_;
  std::size_t family_size_;
};

/// A column for the reference and for the page.
struct ColumnText {
  std::string name, unit, meaning;
  ColumnKind kind = ColumnKind::quantity;
};

/// All columns of a table; those of the family as `Row::family_texts()` describes them.
template <TableRow Row>
[[nodiscard]] std::vector<ColumnText> column_texts() {
  std::vector<ColumnText> texts;
  for_columns<Row>([&]<class Of = Row>(const auto& column) {  // dependent: clang looks into the branch otherwise
    if constexpr (is_family<std::remove_cvref_t<decltype(column)>>) {
      for (ColumnText& text : Of::family_texts()) texts.push_back(std::move(text));
    } else {
      texts.push_back({std::string(column.name), std::string(column.unit), std::string(column.meaning), column.kind});
    }
  });
  return texts;
}

}  // namespace talus
