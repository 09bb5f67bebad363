#include "results/end_points.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

void read_ends(const fs::path& file, const RunFacts& facts, const std::function<bool(std::uint64_t)>& wants,
               EndPoints& ends) {
  using R = EndpointRow;
  TableReader<R> row(file);
  while (row.next()) {
    const std::uint64_t rock = row.get<&R::rock>();
    if (!wants(rock)) continue;
    const Vec3 place = vector(row.get<&R::position_m>());
    if (ends.rocks.empty()) ends.origin = origin_near(place);
    for (int axis = 0; axis < 3; ++axis) ends.positions.push_back(static_cast<float>(place[axis] - ends.origin[axis]));
    ends.rocks.push_back(static_cast<std::uint32_t>(rock));
    ends.sources.push_back(static_cast<std::uint16_t>(ends.source_names.number(facts.source_of(rock))));
    ends.seeders.push_back(static_cast<std::uint16_t>(ends.seeder_names.number(row.get<&R::seeder>())));
    ends.reasons.push_back(static_cast<std::uint8_t>(row.get<&R::end_reason>()));
    ends.masses.push_back(static_cast<float>(row.get<&R::mass_kg>()));
    ends.radii.push_back(static_cast<float>(row.get<&R::radius_m>()));
    ends.max_energies.push_back(static_cast<float>(row.get<&R::max_ke_J>() / 1000));
    ends.max_heights.push_back(static_cast<float>(row.get<&R::max_bounce_m>()));
  }
}

void read_hits(const fs::path& file, EndPoints& ends) {
  const std::size_t words = std::max<std::size_t>(1, (ends.barrier_names.size() + 31) / 32);
  ends.barriers.resize(words * ends.rocks.size());
  if (ends.barrier_names.empty()) return;
  const Names names(ends.barrier_names);
  TableReader<HitRow> row(file);
  auto next = ends.rocks.begin();
  while (row.next()) {  // both tables are in the order of the rocks
    const std::uint64_t rock = row.get<&HitRow::rock>();
    while (next != ends.rocks.end() && *next < rock) ++next;
    if (next == ends.rocks.end()) return;
    const std::optional<std::uint32_t> barrier = names.find(row.get<&HitRow::barrier>());
    if (!barrier) row.csv().refuse("barrier", "is not a barrier of this run", "summary.json names all of them");
    if (*next != rock) continue;
    const auto of_rock = static_cast<std::size_t>(next - ends.rocks.begin());
    ends.barriers[words * of_rock + *barrier / 32] |= 1U << *barrier % 32;
  }
}

}  // namespace

EndPoints end_points(const fs::path& folder, const RunFacts& facts, const std::function<bool(std::uint64_t)>& wants) {
  EndPoints ends;
  ends.source_names = Names(sources_of(facts));
  ends.seeder_names = Names(seeders_of(facts));
  ends.barrier_names = barriers_of(facts);
  read_ends(folder / EndpointRow::file_name, facts, wants, ends);
  read_hits(folder / HitRow::file_name, ends);
  return ends;
}

ChosenRocks::ChosenRocks(std::uint64_t wanted, std::uint64_t done,
                         const std::function<std::uint64_t(std::uint64_t)>& before, const RockTest& has,
                         const RockTest& passes) {
  if (!passes) {
    total_ = before(done);
    const EvenChoice chosen(wanted, total_);
    wants_ = [=](std::uint64_t rock) { return has(rock) && chosen.contains(before(rock)); };
    return;
  }
  const auto passing = std::make_shared<std::vector<std::uint64_t>>();
  for (std::uint64_t rock = 0; rock < done; ++rock) {
    if (passes(rock) && has(rock)) passing->push_back(rock);
  }
  total_ = passing->size();
  const EvenChoice chosen(wanted, total_);
  wants_ = [=](std::uint64_t rock) {
    const auto found = std::ranges::lower_bound(*passing, rock);
    return found != passing->end() && *found == rock &&
           chosen.contains(static_cast<std::uint64_t>(found - passing->begin()));
  };
}

EndPoints end_points(const fs::path& folder, const RunFacts& facts, std::uint64_t rocks, const RockTest& passes) {
  const TableRocks& tables = facts.in_tables;
  const ChosenRocks chosen(
      rocks, facts.summary.rocks.done, [&](std::uint64_t rock) { return tables.endpoints_before(rock); },
      [&](std::uint64_t rock) { return tables.has_endpoint(rock); }, passes);
  EndPoints ends = end_points(folder, facts, chosen.wants());
  ends.total = chosen.total();
  return ends;
}

}  // namespace talus::server
