#include "run_watch.hpp"

namespace talus::server {

namespace {

std::vector<std::string> seeder_names_of(const std::vector<Seeder>& seeders) {
  std::vector<std::string> names;
  for (const Seeder& seeder : seeders) names.push_back(seeder.name);
  return names;
}

}  // namespace

/// A rock with its path and the barriers that it hit.
struct WatchedRock {
  EndpointRow end;
  std::string source;
  Path path;
  std::vector<std::size_t> barriers;
};

namespace {

void add_watched(EndPoints& rocks, const WatchedRock& watched) {
  const EndpointRow& end = watched.end;
  const std::size_t words = std::max<std::size_t>(1, (rocks.barrier_names.size() + 31) / 32);
  rocks.rocks.push_back(static_cast<std::uint32_t>(end.rock));
  rocks.sources.push_back(static_cast<std::uint16_t>(rocks.source_names.number(watched.source)));
  rocks.seeders.push_back(static_cast<std::uint16_t>(rocks.seeder_names.number(end.seeder)));
  rocks.reasons.push_back(static_cast<std::uint8_t>(end.end_reason));
  rocks.masses.push_back(static_cast<float>(end.mass_kg));
  rocks.radii.push_back(static_cast<float>(end.radius_m));
  rocks.max_energies.push_back(static_cast<float>(end.max_ke_J / 1000));
  rocks.max_heights.push_back(static_cast<float>(end.max_bounce_m));
  rocks.barriers.resize(rocks.barriers.size() + words);
  std::uint32_t* bits = rocks.barriers.data() + rocks.barriers.size() - words;
  for (const std::size_t barrier : watched.barriers) bits[barrier / 32] |= 1U << barrier % 32;
}

}  // namespace

struct RunWatch::Part : ObserverPart {
  explicit Part(const RunWatch& own) : watch(own) {}
  void see(const RockRecord& record, const RockLog& log) override {
    if (!watch.chosen_.contains(record.rock)) return;
    WatchedRock& seen = rocks.emplace_back();
    fill(seen.end, watch.context_, record);
    if (record.source.index < watch.model_.sources.size()) seen.source = watch.model_.sources[record.source.index];
    seen.path.rock = record.rock;
    for (std::size_t k = 0; k < log.rows.size(); ++k)
      fill(seen.path.rows.emplace_back(), watch.context_, record, k, log.rows[k]);
    for (const Passage& hit : log.hits) seen.barriers.push_back(hit.barrier.index);
  }

  const RunWatch& watch;
  std::vector<WatchedRock> rocks;
};

RunWatch::RunWatch(const Model& model)
    : model_(model), context_(TableContext::of(model)), chosen_(most_paths, model.rocks()) {
  counts_.planned = model.rocks();
  counts_.rocks_hit.resize(model.barriers.size());
  paths_.rocks.source_names = Names(model.sources);
  paths_.rocks.seeder_names = Names(seeder_names_of(model.seeders));
  for (const Barrier& barrier : model.barriers) paths_.rocks.barrier_names.push_back(barrier.name);
}

std::unique_ptr<ObserverPart> RunWatch::new_part() const { return std::make_unique<Part>(*this); }

void RunWatch::commit(ObserverPart& part) {
  for (const WatchedRock& watched : static_cast<Part&>(part).rocks) {
    if (watched.path.rows.empty()) continue;
    const std::lock_guard lock(mutex_);
    add_watched(paths_.rocks, watched);
    add_path(paths_, watched.path, &model_);
  }
}

void RunWatch::take(const Summary& summary) {
  const std::lock_guard lock(mutex_);
  counts_.done = summary.done;
  counts_.ends = summary.ends;
  for (std::size_t k = 0; k < summary.barriers.size(); ++k) counts_.rocks_hit[k] = summary.barriers[k].rocks_hit;
}

CountsSoFar RunWatch::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

DrawnPaths RunWatch::paths() const {
  const std::lock_guard lock(mutex_);
  DrawnPaths paths = paths_;
  paths.rocks.total = counts_.done;
  paths.starts.push_back(static_cast<std::uint32_t>(paths.times.size()));
  return paths;
}

}  // namespace talus::server
