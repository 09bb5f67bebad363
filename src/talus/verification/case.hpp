#pragma once
// A published case, as described in its folder under verification/, the only place for its tolerances.

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

/// The texts of the case folders, by path below verification/: `2-bowl-lumped-mass/case.toml`.
using Files = std::map<std::string, std::string, std::less<>>;

/// One way to run a project of the case.
struct Run {
  std::string name;
  std::string project;                // a file next to case.toml
  std::vector<std::string> settings;  // as for `talus run --set`
  std::optional<std::int64_t> rocks;  // as for `talus run --rocks`
};

/// Numbers of a table that are left out or have their own tolerance, with the reason.
struct Exception {
  std::vector<std::string> rows;       // empty: all
  std::vector<std::string> columns;    // empty: all
  std::optional<Tolerance> tolerance;  // nullopt: left out
  std::string why;
  [[nodiscard]] bool concerns(const std::string& row, const std::string& column) const;
};

/// One rock's path, row by row.
struct PathTable {
  PublishedTable published;
  std::vector<std::pair<std::string, PathQuantity>> columns;  // of the table, with their quantities
  /// For each row of the table, the zero-based number of the row in a replay; empty with `times`.
  std::vector<std::size_t> events;
  /// Or the column that says when: each row is compared with the motion at that time.
  std::optional<std::size_t> times;
  Tolerance tolerance;
  std::vector<Exception> exceptions;
};

/// Minimum number of rocks of runs whose sampling spread is used: many times that of any published table.
inline constexpr std::int64_t fewest_rocks_of_a_spread = 20000;

/// Statistics of a sample, compared with the spread of samples of the same size.
struct StatisticsTable {
  PublishedTable published;          // rows: statistics
  std::vector<std::string> columns;  // of the table, each a separate sample
  SampleQuantity sample{};
  std::vector<Statistic> tested;  // the others are shown
};

/// Single numbers, each a statistic of a sample; for one rock, the value itself.
struct ValuesTable {
  struct Value {
    std::string what;
    std::string run;
    SampleQuantity sample{};
    Statistic statistic{};
    std::variant<Printed, Interval> published;  // a number, or an interval for ours
    Tolerance tolerance;                        // for a number
  };
  std::vector<Value> values;
};

/// The number of rocks in the table that contribute a value to a sample.
struct CountTable {
  std::uint64_t rocks = 0;
  std::vector<std::pair<std::string, Printed>> published;  // programs and counts
  SampleQuantity sample{};
};

/// Runs that must agree with each other; the first one is the reference.
struct AgreementTable {
  SampleQuantity sample{};
  std::vector<Statistic> statistics;
  int decimals = 3;
};

/// Requirements for every rock: it ends for one of these reasons and never gains energy.
struct SoundnessTable {
  std::vector<EndReason> ends;
  double energy_rise = 0;             // allowed by rounding, relative to the maximum energy of the path
  std::vector<SampleQuantity> shown;  // samples to show next to each other
};

using TableKind = std::variant<PathTable, StatisticsTable, ValuesTable, CountTable, AgreementTable, SoundnessTable>;

struct Table {
  std::string title;
  std::string source;             // its place there
  std::vector<std::string> runs;  // names; the table is compared with each run, an agreement compares the runs
  std::string why;                // the reason for the tolerance
  TableKind kind;
};

struct Case {
  std::string name;  // of the folder
  std::string title;
  std::string source;  // of the published numbers
  std::string about;
  std::vector<std::string> notes;
  std::vector<Run> runs;
  std::vector<Table> tables;
  [[nodiscard]] const Run& run(std::string_view run_name) const;
};

/// Throws BadInput with all problems of its case.toml.
[[nodiscard]] Case read_case(const Files& files, const std::string& name);

}  // namespace talus::verification
