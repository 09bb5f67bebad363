#include "talus/export/stored_paths.hpp"

#include <string>

#include "talus/archive/even_choice.hpp"
#include "talus/core/stop.hpp"

namespace talus {

TableContext path_context_of(const StoreFacts& facts) {
  TableContext context;
  context.frame.origin = facts.origin;
  context.gravity = facts.gravity.norm();
  context.energy_datum = facts.energy_datum;
  context.seeders = facts.seeders;
  context.has_blocks = facts.has_blocks;
  return context;
}

void write_stored_paths(const TrajectoryStore& store, std::optional<std::uint64_t> wanted, TextSink& out) {
  const TableContext context = path_context_of(store.facts());
  const std::uint64_t rocks = store.rocks().size();
  const EvenChoice choice(wanted.value_or(rocks), rocks);
  const std::size_t columns = columns_in_run<PathEventRow>(context.has_blocks);
  std::string text = header_of<PathEventRow>({}, columns);
  StoredTrajectory trajectory;
  PathEventRow row;
  CsvMemory memory;
  for (std::size_t place = 0; place < rocks; ++place) {
    if (!choice.contains(place)) continue;
    stop_point();
    store.read(place, trajectory);
    for (std::size_t k = 0; k < trajectory.rows.size(); ++k) {
      fill(row, context, trajectory.record, k, trajectory.rows[k]);
      append_row(text, row, &memory, columns);
    }
    out.write(text);
    text.clear();
  }
  out.write(text);
}

}  // namespace talus
