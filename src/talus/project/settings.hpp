#pragma once
// The one declaration of every setting of the project file: its table and key, the member of project.hpp that it fills,
// unit, range, conditions, exclusions, form group, help topic, meaning and source. The reader, the checks, the JSON
// Schema, the reference page, the forms of the workbench and the echo in summary.json are all generated from it. Each
// table has its own file in settings/. Defaults are not repeated here: they are the initial values of the structs.

#include <any>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "talus/project/project.hpp"
#include "talus/project/words.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::project {

/// The permitted values of a setting (for a random property, of its mean).
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool most_excluded = false;
  bool infinite_allowed = false;  // `inf` is permitted
  bool limits_draws = true;       // of a distribution; else only its mean
  std::string_view too_low{};     // why a smaller number makes no sense
  std::string_view too_high{};    // why a larger number makes no sense

  [[nodiscard]] bool contains(double value) const;
  [[nodiscard]] bool is_everything() const;
  /// For messages: "0 to 1", "more than 0", "0 or more".
  [[nodiscard]] std::string text() const;
};

/// Why a number inside the range is probably a mistake, and how to correct it.
struct Doubt {
  std::string why;
  std::string hint;
};

// Members whose form in the file differs from their type.
struct PositionSlot {
  Seeder* seeder;  // [x, z] or [x, y, z], z may be "surface" or omitted: the point of a point seeder
};
struct PointsSlot {
  Seeder* seeder;  // two or more positions: the points of a line seeder
};
struct PlanLineSlot {
  std::vector<std::array<double, 2>>* line;  // x in 2D, [[x, y], ...] in 3D
};
struct PlanPointSlot {
  std::optional<std::array<double, 2>>* point;  // [x] in 2D, [x, y] in 3D
};
struct PlanPolygonSlot {
  std::vector<std::array<double, 2>>* polygon;  // [[x, y], ...], three or more
};
struct SizeSlot {
  std::optional<RockSize>* size;  // a random property: the size of the rocks, if it is of this kind
  SizeOf of;
};
struct LibrarySlot {
  Material* material;  // the key of a library material, whose values it takes
};
struct LawsSlot {
  Analysis* analysis;  // the word of a set of laws, whose defaults it takes
};
struct DirectionSlot {
  std::optional<std::array<double, 3>>* direction;  // [x, z] or [x, y, z], or "downslope" (nullopt)
};
struct LimitSlot {
  std::optional<std::int64_t>* limit;  // "all" (nullopt), "none" (0) or a number
};
struct MapCellSlot {
  std::optional<double>* size;  // "terrain" (nullopt) or a number of metres
};
struct SectionSlot {
  std::vector<std::array<double, 2>>* vertices;  // [[x, z], ...]
  std::filesystem::path* file;                   // or the name of a file that has them
};
struct FilesSlot {
  std::vector<std::filesystem::path>* files;  // a name, or a list of names
};

template <class Enumerations>
struct SlotWith;
template <class... Listed>
struct SlotWith<const std::tuple<Listed...>> {
  using Type = std::variant<
      bool*, double*, std::optional<double>*, std::int64_t*, std::optional<std::int64_t>*, std::uint64_t*, std::string*,
      std::filesystem::path*, std::array<double, 3>*, Distribution*, std::optional<Distribution>*,
      std::vector<std::array<double, 2>>*, std::vector<std::array<double, 3>>*,
      std::vector<std::array<std::int64_t, 3>>*, std::vector<std::vector<std::array<double, 3>>>*,
      std::vector<std::string>*, std::vector<std::int64_t>*, std::vector<double>*, std::optional<std::vector<double>>*,
      std::map<std::int32_t, std::string>*, std::map<std::string, std::string>*, MapSubjects*,
      typename Listed::Enumeration*..., PositionSlot, PointsSlot, PlanLineSlot, PlanPointSlot, PlanPolygonSlot,
      SizeSlot, LibrarySlot, LawsSlot, DirectionSlot, LimitSlot, MapCellSlot, SectionSlot, FilesSlot>;
};

/// The member that a setting fills, in one row of its table; of enumerations those of words.hpp.
using Slot = SlotWith<decltype(enumerations)>::Type;

/// Whether a member is a random property.
[[nodiscard]] bool is_random_property(const Slot& slot);
/// The random property in a member; null if it is another kind of member or is not given.
[[nodiscard]] Distribution* distribution_in(const Slot& slot);

/// One row of a table: the struct that its settings are members of.
class Row {
 public:
  template <class Struct>
  Row(Struct* row) : row_(row) {}
  /// Null if the row is another struct.
  template <class Struct>
  [[nodiscard]] Struct* if_is() const {
    Struct* const* const found = std::any_cast<Struct*>(&row_);
    return found == nullptr ? nullptr : *found;
  }
  /// Throws std::bad_any_cast if the row is another struct.
  template <class Struct>
  [[nodiscard]] Struct& as() const {
    return *std::any_cast<Struct*>(row_);
  }

 private:
  std::any row_;  // a pointer
};

/// A condition on another setting: of the same row (its key), or of a table with one row ("terrain.raster").
struct Condition {
  enum class Kind { given, absent, one_of, none_of };
  std::string_view key;
  Kind kind = Kind::given;
  std::vector<std::string_view> values{};  // for one_of and none_of: as in the file, strings without quotes
};

/// What happens to a setting that does not apply.
enum class Otherwise {
  kept,     // no message: a material may describe the ground for both models
  warned,   // warning: it has no effect
  refused,  // error: the project would do something else than it says
};

/// One requirement for a setting to have an effect: at least one of its conditions is true.
struct Need {
  std::vector<Condition> any_of;
  Otherwise otherwise = Otherwise::warned;
  // The message if none is true; empty: generated from the conditions. "{}" is replaced by the present value of the
  // first condition's key.
  std::string_view what{};  // follows the key: "is given without a section"
  std::string_view why{};
  std::string_view hint{};
};

/// A section of the documents.
struct Topic {
  std::string_view document;  // a file of docs/; empty: none
  std::string_view heading;
};

struct Setting {
  std::string_view key;
  std::function<Slot(Row)> slot;
  std::string_view unit{};  // empty: none
  Range range{};
  bool required = false;
  std::string_view without_it{};     // the default, if the struct's initial value does not give it
  std::size_t most_entries = 0;      // of a list; 0: no limit
  std::vector<Need> applies_when{};  // it has an effect if all of them are met; the first unmet one is reported
  std::vector<std::string_view> always_accepted{};  // values, as in the file, that are always accepted: `false`
  std::string_view title{};                         // of its field in forms; empty: made from the key
  std::string_view group{};                         // of fields in forms: one of the table's
  Topic topic{};                                    // empty: the table's
  std::string_view meaning{};  // follows "Lumped mass: " or "Rigid sphere: " if it is for one model only
  std::string_view source{};
  std::function<std::optional<double>(double)> slip{};  // the probable intention of a number out of range
  std::function<std::optional<Doubt>(double)> doubt{};  // for a number inside the range
};

/// The words of the rock models that the setting is limited to; empty: of all.
[[nodiscard]] std::span<const std::string_view> models_of(const Setting& setting);

/// Its meaning, preceded by the models it is limited to: "Rigid sphere and body: ..."
[[nodiscard]] std::string meaning_of(const Setting& setting);

/// Alternative ways to specify the same thing, each a list of keys. Keys of different ways exclude each other.
using Choice = std::vector<std::vector<std::string_view>>;

/// Fields that are grouped in a form.
struct Group {
  std::string_view title;
  bool folded = false;  // initially, unless one of its settings is given
};

struct Table {
  std::string_view key;   // empty: the keys before the first table
  bool repeated = false;  // [[key]]
  bool required = false;
  std::string_view meaning;
  std::vector<Setting> settings;
  std::vector<Choice> choices{};
  std::vector<Group> groups{};  // in the order of the form; may be empty
  Topic topic{};
  std::function<Row(Project&)> add;                // returns the row to read into; a new one for each [[key]]
  std::function<std::vector<Row>(Project&)> rows;  // all rows

  [[nodiscard]] const Setting* find(std::string_view setting) const;
  /// Keys that may not be given together with this one: those of other ways of its choices.
  [[nodiscard]] std::vector<std::string_view> excluded_by(std::string_view setting) const;
  /// The keys of all ways of its first choice: for [terrain], those that define the surface.
  [[nodiscard]] std::vector<std::string_view> keys_of_ways() const;
  /// As in the file: "[analysis]", "[[seeder]]".
  [[nodiscard]] std::string heading() const;
};

/// Every table of the project file, in the order of the reference.
[[nodiscard]] const std::vector<Table>& tables();

/// The keys of a random property, `{ mean = 0.5, distribution = "normal", ... }`: a table like the others, used by all
/// settings of type Distribution.
[[nodiscard]] const Table& distribution_table();

/// The table of this key. Expects it to exist.
[[nodiscard]] const Table& table(std::string_view key);

/// The setting `table.key`. Expects it to exist.
[[nodiscard]] const Setting& setting(std::string_view table, std::string_view key);

/// The limits of draws of a random property: the range of its setting.
[[nodiscard]] Bounds bounds(std::string_view table, std::string_view key);
[[nodiscard]] Bounds bounds(const Range& range);

}  // namespace talus::project
