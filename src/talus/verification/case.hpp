#pragma once
// A published case: what its folder under verification/ says. Tolerances live there and nowhere else.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "talus/verification/observed.hpp"
#include "talus/verification/printed.hpp"
#include "talus/verification/sampling_spread.hpp"
#include "talus/verification/tolerance.hpp"

namespace talus::verification {

/// The texts of the case folders, by their paths below verification/: `2-bowl-lumped-mass/case.toml`.
using Files = std::map<std::string, std::string, std::less<>>;

/// One way to run a project of the case.
struct Run {
  std::string name;
  std::string project;                // the file beside case.toml
  std::vector<std::string> settings;  // as after `talus run --set`
  std::optional<std::int64_t> rocks;  // as after `talus run --rocks`
};

/// Numbers of a table that are left out, or have a tolerance of their own; with the reason.
struct Exception {
  std::vector<std::string> rows;       // none: all
  std::vector<std::string> columns;    // none: all
  std::optional<Tolerance> tolerance;  // nothing: left out
  std::string why;
  [[nodiscard]] bool concerns(const std::string& row, const std::string& column) const;
};

/// One rock's path, row by row.
struct PathTable {
  PublishedTable published;
  std::vector<std::pair<std::string, PathQuantity>> columns;  // the table's, and what they are here
  /// For each row of the table, the number of ours among all that a replay shows, counted from 0.
  std::vector<std::size_t> events;
  Tolerance tolerance;
  std::vector<Exception> exceptions;
};

/// Runs whose samples' spread is looked at have at least so many rocks, many times those of any published table.
inline constexpr std::int64_t fewest_rocks_of_a_spread = 20000;

/// Statistics of a sample, against the spread of samples as large.
struct StatisticsTable {
  PublishedTable published;          // rows: statistics
  std::vector<std::string> columns;  // of the table, each a sample of its own
  SampleQuantity sample{};
  std::vector<Statistic> tested;  // the others are shown
};

/// Single numbers, each a statistic of a sample: of one rock, the value itself.
struct ValuesTable {
  struct Value {
    std::string what;
    std::string run;
    SampleQuantity sample{};
    Statistic statistic{};
    std::variant<Printed, Interval> published;  // a number, or what ours must lie between
    Tolerance tolerance;                        // of a number
  };
  std::vector<Value> values;
};

/// How many of the table's rocks do something that a sample has one value for.
struct CountTable {
  std::uint64_t rocks = 0;
  std::vector<std::pair<std::string, Printed>> published;  // whose, and how many
  SampleQuantity sample{};
};

/// Runs that must not differ from each other; the first one is the reference.
struct AgreementTable {
  SampleQuantity sample{};
  std::vector<Statistic> statistics;
  int decimals = 3;
};

/// What must be true of every rock: it ends, in one of these ways, and never gains energy.
struct SoundnessTable {
  std::vector<EndReason> ends;
  double energy_rise = 0;             // allowed, of the greatest energy of the rock's path: rounding
  std::vector<SampleQuantity> shown;  // samples to lay side by side
};

using TableKind = std::variant<PathTable, StatisticsTable, ValuesTable, CountTable, AgreementTable, SoundnessTable>;

struct Table {
  std::string title;
  std::string manual;             // where it stands there
  std::vector<std::string> runs;  // names; the table is compared with each, or, for an agreement, among them
  std::string why;                // of the tolerance
  TableKind kind;
};

struct Case {
  std::string name;  // of the folder
  std::string title;
  std::string manual;
  std::string about;
  std::vector<std::string> notes;
  std::vector<Run> runs;
  std::vector<Table> tables;
  [[nodiscard]] const Run& run(std::string_view run_name) const;
};

/// Throws BadInput with every problem of its case.toml.
[[nodiscard]] Case read_case(const Files& files, const std::string& name);

}  // namespace talus::verification
