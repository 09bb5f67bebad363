#include "talus/archive/path_reader.hpp"

#include <fmt/format.h>

#include "talus/core/problems.hpp"

namespace talus {

PathEventRow path_row(const TableReader<PathEventRow>& row) {
  return row.part<&PathEventRow::rock, &PathEventRow::event, &PathEventRow::state, &PathEventRow::time_s,
                  &PathEventRow::position_m, &PathEventRow::velocity_m_s, &PathEventRow::ke_translational_J,
                  &PathEventRow::ke_rotational_J, &PathEventRow::pe_J>();
}

void refuse_other_rock(const TableReader<PathEventRow>& row, std::uint64_t rock, std::uint64_t unfinished) {
  row.csv().refuse("", fmt::format("rock {} begins before rock {} has ended", rock, unfinished),
                   "a path's last row has the state ended",
                   "The file was cut or joined by hand; run the project again");
}

void refuse_unfinished_path(const std::filesystem::path& file, std::uint64_t rock) {
  throw BadInput(Problem{.file = file.string(),
                         .what = fmt::format("the path of rock {} does not end", rock),
                         .why = "a path's last row has the state ended",
                         .hint = "The file was cut short or damaged; run the project again to write it anew"});
}

PathReader::PathReader(const std::filesystem::path& file) : file_(file), row_(file) {}

bool PathReader::next(const std::function<bool(std::uint64_t)>& wants) {
  for (bool is_wanted = false; !is_wanted;) {
    path_.rows.clear();
    bool begins = true;
    for (bool has_ended = false; !has_ended; begins = false) {
      if (!row_.next()) {
        if (begins) return false;
        refuse_unfinished_path(file_, path_.rock);
      }
      const std::uint64_t rock = row_.get<&PathEventRow::rock>();
      if (begins) {
        path_.rock = rock;
        is_wanted = wants(rock);
      } else if (rock != path_.rock) {
        refuse_other_rock(row_, rock, path_.rock);
      }
      has_ended = row_.get<&PathEventRow::state>() == PathState::ended;
      if (is_wanted) path_.rows.push_back(path_row(row_));
    }
  }
  return true;
}

}  // namespace talus
