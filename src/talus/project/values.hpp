#pragma once
// Reads the values of one table into the members of its settings, and reports what is wrong with them.

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/maps/map_subjects.hpp"
#include "talus/project/document.hpp"
#include "talus/project/row_keys.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// Whether the terrain is a section without a width, so that positions are [x, z]. Follows from the keys alone, before
/// any value is read; nullopt if no key defines a terrain.
[[nodiscard]] std::optional<bool> is_2d(const toml::table& root);

/// The name of a row in problems: `[analysis]`, `material "Type One"`, `seeder 2` (one-based).
[[nodiscard]] std::string name_of_row(const Table& table, const toml::table& row, std::size_t index);

/// "1 vertex", "2 vertices".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view several);

/// A number as people write it: whole numbers without a decimal point or an exponent.
[[nodiscard]] std::string number_text(double value);

/// How many wrong entries of one list are reported.
inline constexpr std::size_t most_reported = 10;

/// The indices of entries that occur earlier in the list.
[[nodiscard]] std::vector<std::size_t> repeated(const std::vector<double>& list);

class ValueReader {
 public:
  /// `tables` are those of the file, for hints; they must outlive the reader.
  ValueReader(const Document& document, Problems& problems, const std::vector<Table>& tables = project::tables());

  /// Reads every key of `from` into `row`. `where` names the row in problems.
  void read(const Table& table, const toml::table& from, Row row, const std::string& where);

  [[nodiscard]] const std::vector<NamedFile>& named_files() const { return named_files_; }
  /// The values that were reported and are not in the project; rules across keys skip them.
  [[nodiscard]] const std::unordered_set<const toml::node*>& refused() const { return refused_; }

 private:
  /// The value being read, and its name in problems.
  struct Value {
    const Setting& setting;
    const toml::node& node;
    const toml::table& row;  // the other keys of its table
    std::string where;
    std::string name;  // the key; of a part, with its path: `normal_restitution std_dev`, `section[2]`
  };

  void read_rows(const Table& table, const toml::table& from, Row row, const std::string& where,
                 const std::string& lead);

  bool into(const Value&, bool*);
  bool into(const Value&, double*);
  bool into(const Value&, std::optional<double>*);
  bool into(const Value&, std::int64_t*);
  bool into(const Value&, std::optional<std::int64_t>*);
  bool into(const Value&, std::uint64_t*);
  bool into(const Value&, std::string*);
  bool into(const Value&, std::filesystem::path*);
  bool into(const Value&, std::array<double, 3>*);
  bool into(const Value&, Distribution*);
  bool into(const Value&, std::optional<Distribution>*);
  bool into(const Value&, std::map<std::int32_t, std::string>*);
  bool into(const Value&, std::map<std::string, std::string>*);
  bool into(const Value&, MapSubjects*);
  bool into(const Value&, PositionSlot);
  bool into(const Value&, PointsSlot);
  bool into(const Value&, SizeSlot);
  bool into(const Value&, PlanLineSlot);
  bool into(const Value&, PlanPointSlot);
  bool into(const Value&, PlanPolygonSlot);
  bool into(const Value&, LibrarySlot);
  bool into(const Value&, LawsSlot);
  bool into(const Value&, DirectionSlot);
  bool into(const Value&, LimitSlot);
  bool into(const Value&, std::optional<std::vector<double>>*);
  bool into(const Value&, MapCellSlot);
  bool into(const Value&, SectionSlot);
  bool into(const Value&, FilesSlot);
  template <class Item>
  bool into(const Value&, std::vector<Item>*);
  template <class Number, std::size_t count>
  bool into(const Value&, std::array<Number, count>*);
  template <class Enumeration>
  requires std::is_enum_v<Enumeration>
  bool into(const Value&, Enumeration*);

  /// Reports parts of a random property that its kind lacks or does not have.
  void check_parts(const Value& value, const toml::table& parts, DistributionKind kind);

  struct Position {
    std::array<double, 3> point{};
    bool on_surface = false;
  };
  std::optional<Position> position(const Value& value);
  /// Points [x, y]; reports the first that is not a point, or that repeats the previous one.
  std::optional<std::vector<std::array<double, 2>>> plan_points(const Value& value);
  bool plan_coordinate(const Value& value, double* member);
  void doubt(const Value& value, double number);
  void warn(const Value& value, std::string what, std::string why, std::string hint);

  /// Adds a problem about the value; returns false, for readers to return.
  bool refuse(const Value& value, std::string what, std::string why, std::string hint = {});
  /// `refuse` for the most common problem: the value is not of the expected kind.
  bool refuse_kind(const Value& value, const std::string& expected, std::string hint = {});

  const Document& document_;
  Problems& problems_;
  const std::vector<Table>& tables_;
  // Without a terrain, the number of coordinates of a position is unknown: positions then count as refused, and only
  // the missing terrain is reported.
  bool dimension_is_known_;
  bool two_dimensional_;
  std::unordered_set<const toml::node*> refused_;
  std::vector<NamedFile> named_files_;
};

}  // namespace talus::project
