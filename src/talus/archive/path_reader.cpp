#include "talus/archive/path_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

#include "talus/archive/table_columns.hpp"
#include "talus/core/problems.hpp"

namespace talus::io {

namespace {

constexpr std::size_t place_of(std::string_view name) { return io::place_of(path_columns, name); }

constexpr std::size_t rock_column = place_of("rock"), event = place_of("event"), state_column = place_of("state"),
                      time = place_of("time_s"), x = place_of("x_m"), vx = place_of("vx_m_s"),
                      ke_translational = place_of("ke_translational_J"), ke_rotational = place_of("ke_rotational_J"),
                      pe = place_of("pe_J");

std::array<double, 3> triple(const CsvReader& row, std::size_t first) {
  return {row.number(first), row.number(first + 1), row.number(first + 2)};
}

constexpr std::array path_states{PathState::projectile, PathState::impact,  PathState::sliding,
                                 PathState::rolling,    PathState::barrier, PathState::ended};

std::optional<PathState> state_named(std::string_view text) {
  const auto found =
      std::ranges::find(path_states, text, [](PathState state) { return std::string_view(name(state)); });
  return found == path_states.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

PathState state_in(const CsvReader& row, std::size_t column) {
  if (const auto state = state_named(row.text(column))) return *state;
  std::string known;
  for (const PathState state : path_states) known += (known.empty() ? "" : ", ") + std::string(name(state));
  row.refuse("state", fmt::format("\"{}\" is not a state", row.text(column)), "expected one of " + known);
}

Path path_of(const std::vector<std::vector<std::string>>& rows) {
  const auto refuse = [](const std::string& text) {
    throw BadInput(Problem{.what = "\"" + text + "\" is not what stands in a row of a path"});
  };
  const auto number = [&](const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) refuse(text);
    return value;
  };
  Path path{.rock = static_cast<std::uint64_t>(number(rows.at(0).at(rock_column)))};
  for (const std::vector<std::string>& row : rows) {
    const auto triple_at = [&](std::size_t first) {
      return std::array{number(row[first]), number(row[first + 1]), number(row[first + 2])};
    };
    const auto state = state_named(row.at(state_column));
    if (!state || row.size() != path_columns.size()) refuse(row[state_column]);
    path.rows.push_back({.event = path.rows.size(),
                         .state = *state,
                         .time_s = number(row[time]),
                         .position_m = triple_at(x),
                         .velocity_m_s = triple_at(vx),
                         .ke_translational_J = number(row[ke_translational]),
                         .ke_rotational_J = number(row[ke_rotational]),
                         .pe_J = number(row[pe])});
  }
  return path;
}

PathReader::PathReader(const std::filesystem::path& file) : file_(file), row_(file, path_columns) {}

bool PathReader::next(const std::function<bool(std::uint64_t)>& wants) {
  for (bool is_wanted = false; !is_wanted;) {
    path_.rows.clear();
    for (bool has_ended = false; !has_ended;) {
      const bool begins = path_.rows.empty();
      if (!row_.next()) {
        if (begins) return false;
        throw BadInput(Problem{.file = file_.string(),
                               .what = fmt::format("the path of rock {} does not end", path_.rock),
                               .why = "a path's last row has the state ended",
                               .hint = "The file was cut short or damaged; run the project again to get it whole"});
      }
      const auto rock = static_cast<std::uint64_t>(row_.whole_number(rock_column));
      if (begins) {
        path_.rock = rock;
        is_wanted = wants(rock);
      } else if (rock != path_.rock) {
        row_.refuse("", fmt::format("rock {} begins before rock {} has ended", rock, path_.rock),
                    "a path's last row has the state ended",
                    "The file was cut or joined by hand; run the project again");
      }
      const PathState state = state_in(row_, state_column);
      has_ended = state == PathState::ended;
      if (!is_wanted && !begins) continue;
      path_.rows.push_back({.event = static_cast<std::uint64_t>(row_.whole_number(event)),
                            .state = state,
                            .time_s = row_.number(time),
                            .position_m = triple(row_, x),
                            .velocity_m_s = triple(row_, vx),
                            .ke_translational_J = row_.number(ke_translational),
                            .ke_rotational_J = row_.number(ke_rotational),
                            .pe_J = row_.number(pe)});
    }
  }
  return true;
}

}  // namespace talus::io
