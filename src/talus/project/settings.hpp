#pragma once
// The one declaration of every setting of the project file: its table and key, the member of project.hpp that it fills,
// unit, range, when it applies, what excludes it, group, help, meaning and source. The reader, the checks, the JSON
// Schema, the reference page, the forms of the workbench and the echo in summary.json are all made from it; each table
// has its file in settings/. Defaults are not repeated here: they are the initial values of the structs.

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "talus/project/project.hpp"
#include "talus/project/words.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::project {

/// Which numbers a setting may be (for a random property: which means).
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool most_excluded = false;
  bool infinite_allowed = false;  // `inf` is a value
  std::string_view too_low{};     // why a smaller number makes no sense
  std::string_view too_high{};    // why a larger one makes none

  [[nodiscard]] bool contains(double value) const;
  [[nodiscard]] bool is_everything() const;
  /// For people: "0 to 1", "more than 0", "0 or more".
  [[nodiscard]] std::string text() const;
};

/// Why a number inside the range is probably not what was meant, and what would then be right.
struct Doubt {
  std::string why;
  std::string hint;
};

// Members whose form in the file is not that of their type.
struct PositionSlot {
  Seeder* seeder;  // [x, z] or [x, y, z], z may be "surface" or left out: the one point of a point seeder
};
struct PointsSlot {
  Seeder* seeder;  // two or more of them: a line seeder
};
struct PlanLineSlot {
  Barrier* barrier;  // x in 2D, [[x, y], ...] in 3D
};
struct PlanPolygonSlot {
  std::vector<std::array<double, 2>>* polygon;  // [[x, y], ...], three or more
};
struct LibrarySlot {
  Material* material;  // the key of a material of the library, whose values it takes
};
struct DirectionSlot {
  std::optional<std::array<double, 3>>* direction;  // [x, z] or [x, y, z], or "downslope" (nothing here)
};
struct RockLimitSlot {
  std::optional<std::int64_t>* limit;  // "all" (nothing here), "none" (0) or a number of rocks
};
struct MapCellSlot {
  std::optional<double>* size;  // "terrain" (nothing here) or a number of metres
};

/// The member that a setting fills, in one row of its table.
using Slot =
    std::variant<bool*, double*, std::optional<double>*, std::int64_t*, std::optional<std::int64_t>*, std::uint64_t*,
                 std::string*, std::filesystem::path*, std::array<double, 3>*, Distribution*,
                 std::optional<Distribution>*, std::vector<std::array<double, 2>>*, std::vector<std::array<double, 3>>*,
                 std::vector<std::array<std::int64_t, 3>>*, std::vector<std::vector<std::array<double, 3>>>*,
                 std::vector<std::string>*, std::vector<std::int64_t>*, std::vector<double>*,
                 std::map<std::int32_t, std::string>*, std::map<std::string, std::string>*, MapSubjects*, RockModel*,
                 SlidingMethod*, FrictionSource*, MaterialSampling*, SamplingMethod*, SeederType*, Forest*,
                 DistributionKind*, PlaceInCell*, DesignStandard*, DesignLevel*, DesignEnergy*, PositionSlot,
                 PointsSlot, PlanLineSlot, PlanPolygonSlot, LibrarySlot, DirectionSlot, RockLimitSlot, MapCellSlot>;

/// One row of a table: the struct that its settings are members of.
using Row = std::variant<Project*, Analysis*, Sampling*, Terrain*, Material*, Ground*, Area*, Seeder*, Barrier*,
                         Design*, Output*, Distribution*>;

/// What another setting must say: of the same row (its key), or of a table that there is one of ("terrain.raster").
struct Condition {
  enum class Asks { given, absent, one_of, none_of };
  std::string_view key;
  Asks asks = Asks::given;
  std::vector<std::string_view> values{};  // of one_of and none_of: as in the file, texts without quotes
};

/// What becomes of a setting that does not apply.
enum class Otherwise {
  kept,     // it describes the ground for either model, say
  warned,   // a warning says that it has no effect
  refused,  // an error: the project says something else than it does
};

/// One reason for which a setting has an effect: any of its conditions holds.
struct Need {
  std::vector<Condition> any_of;
  Otherwise otherwise = Otherwise::warned;
  // The message where none holds; empty: made of the conditions. "{}" stands for what the first of them is now.
  std::string_view what{};  // after the key: "is given without a section"
  std::string_view why{};
  std::string_view hint{};
};

/// Where the documents say more.
struct Topic {
  std::string_view document;  // a file of docs/; empty: nowhere
  std::string_view heading;
};

struct Setting {
  std::string_view key;
  std::function<Slot(Row)> slot;
  std::string_view unit{};  // empty: none
  Range range{};
  bool required = false;
  std::string_view without_it{};  // what holds where the key is absent and the struct's initial value does not say it
  std::size_t most_entries = 0;   // of a list; 0: as many as anybody likes
  std::vector<Need>
      applies_when{};  // all of them must be met for it to have an effect; the first that is not is reported
  std::vector<std::string_view> asks_nothing{};  // values, as in the file, that need nothing: `false`
  std::string_view title{};                      // of its field in forms, where the key does not read well
  std::string_view group{};                      // of the form, one of the table's
  Topic topic{};                                 // without one the table's
  std::string_view meaning{};                    // one sentence; after its model's name and a colon where it has one
  std::string_view source{};
  std::function<std::optional<double>(double)> slip{};  // what a number out of range was probably meant to be
  std::function<std::optional<Doubt>(double)> doubt{};  // for a number inside the range
};

/// The only rock model that it has any effect on, where there is one.
[[nodiscard]] std::optional<RockModel> only_model(const Setting& setting);

/// Its meaning, with the model that it is for in front: "Rigid sphere: height of the bumps of a rough ground."
[[nodiscard]] std::string meaning_of(const Setting& setting);

/// Ways to say one thing, each by the keys of a list. Keys of different ways exclude each other.
using Choice = std::vector<std::vector<std::string_view>>;

/// Fields that stand together in a form.
struct Group {
  std::string_view title;
  bool folded = false;  // until it is opened, or something in it is given
};

struct Table {
  std::string_view key;   // empty: the keys before the first table
  bool repeated = false;  // [[key]]
  bool required = false;
  std::string_view meaning;
  std::vector<Setting> settings;
  std::vector<Choice> choices{};
  std::vector<Group> groups{};  // in the order of the form; none: it has no groups
  Topic topic{};
  std::function<Row(Project&)> add;                // the row to read into; a new one for each [[key]]
  std::function<std::vector<Row>(Project&)> rows;  // all rows that there are

  [[nodiscard]] const Setting* find(std::string_view setting) const;
  /// Keys that may not stand beside this one: those of other ways of its choices.
  [[nodiscard]] std::vector<std::string_view> excluded_by(std::string_view setting) const;
  /// The keys of all ways of its first choice: of a terrain those that make it.
  [[nodiscard]] std::vector<std::string_view> keys_of_ways() const;
  /// As in the file: "[analysis]", "[[seeder]]".
  [[nodiscard]] std::string heading() const;
};

/// Every table of the project file, in the order of the contract.
[[nodiscard]] const std::vector<Table>& tables();

/// The keys of a random property, `{ mean = 0.5, distribution = "normal", ... }`: a table like the others, used by all
/// settings that are a Distribution.
[[nodiscard]] const Table& distribution_table();

/// A table that is known to exist.
[[nodiscard]] const Table& table(std::string_view key);

/// A setting that is known to exist.
[[nodiscard]] const Setting& setting(std::string_view table, std::string_view key);

/// Limits of what may be drawn for a random property: the range of its setting.
[[nodiscard]] Bounds bounds(std::string_view table, std::string_view key);
[[nodiscard]] Bounds bounds(const Range& range);

}  // namespace talus::project
