#include "talus/store/store_observer.hpp"

#include <algorithm>
#include <utility>

#include "talus/store/rock_choice.hpp"
#include "talus/store/store_file.hpp"
#include "talus/store/varint.hpp"

namespace talus {

namespace {

/// Rocks are dropped once they exceed the budget by this share, so that it is not done for each block.
constexpr double most_excess = 0.25;

std::string bytes_of(const StoreFacts& facts) {
  ByteWriter out;
  facts.save(out);
  return out.take();
}

}  // namespace

class StoreObserver::Part : public ObserverPart {
 public:
  explicit Part(const StoreObserver& observer)
      : observer_(observer), encoder_(observer.facts_->gravity, observer.facts_->grid) {}

  void see(const RockRecord& record, const RockLog& log) override {
    const std::uint64_t place = observer_.place_of(record.rock);
    if (place >= observer_.limit_.load(std::memory_order_relaxed)) return;
    const std::size_t paths = block.paths.size(), cells = block.cells.size();
    encoder_.encode(record, log, block.paths);
    put_runs(encoder_.cells(), block.cells);
    block.rocks.push_back({record.rock, place, static_cast<std::uint32_t>(log.rows.size()),
                           static_cast<std::uint32_t>(block.cells.size() - cells),
                           static_cast<std::uint32_t>(block.paths.size() - paths)});
  }

  Block block;

 private:
  const StoreObserver& observer_;
  PathEncoder encoder_;
};

StoreObserver::StoreObserver(std::uint64_t budget, const Model& model)
    : budget_(budget), facts_(StoreFacts::of(model)) {}

std::uint64_t StoreObserver::place_of(std::uint64_t rock) const { return place_in_choice(facts_->seed, rock); }

bool StoreObserver::is_wanted(std::uint64_t rock) const {
  const std::uint64_t limit = limit_.load(std::memory_order_relaxed);
  return limit == no_limit || place_of(rock) < limit;
}

std::unique_ptr<ObserverPart> StoreObserver::new_part() const { return std::make_unique<Part>(*this); }

void StoreObserver::commit(ObserverPart& part) {
  add(std::move(static_cast<Part&>(part).block));
  if (static_cast<double>(cost_) > (1 + most_excess) * static_cast<double>(budget_)) settle();
}

void StoreObserver::add(Block block) {
  if (block.rocks.empty()) return;
  for (const Kept& kept : block.rocks) cost_ += kept.cost();
  block.cells.shrink_to_fit();
  block.paths.shrink_to_fit();
  blocks_.push_back(std::move(block));
}

template <class Visit>
void StoreObserver::for_items(const Block& block, const Visit& visit) {
  std::string_view cells = block.cells, paths = block.paths;
  for (const Kept& kept : block.rocks) {
    visit(Item{&kept, cells.substr(0, kept.cells_size), paths.substr(0, kept.path_size)});
    cells.remove_prefix(kept.cells_size);
    paths.remove_prefix(kept.path_size);
  }
}

void StoreObserver::drop_from(std::uint64_t place) {
  limit_ = std::min(limit_.load(), place);
  cost_ = 0;
  for (Block& block : std::exchange(blocks_, {})) {
    Block left;
    for_items(block, [&](const Item& item) {
      if (item.kept->place >= limit_) return;
      left.rocks.push_back(*item.kept);
      left.cells += item.cells;
      left.paths += item.path;
    });
    add(std::move(left));
    block = {};
  }
}

void StoreObserver::settle() {
  if (cost_ <= budget_) return;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> costs;  // by place
  for (const Block& block : blocks_) {
    for (const Kept& kept : block.rocks) costs.emplace_back(kept.place, kept.cost());
  }
  std::ranges::sort(costs);
  std::uint64_t total = 0;
  for (const auto& [place, cost] : costs) {
    total += cost;
    if (total > budget_) return drop_from(place);
  }
}

std::vector<StoreObserver::Item> StoreObserver::in_order() const {
  std::vector<Item> items;
  for (const Block& block : blocks_) for_items(block, [&](const Item& item) { items.push_back(item); });
  const auto rock_of = [](const Item& item) { return item.kept->rock; };
  if (!std::ranges::is_sorted(items, {}, rock_of)) std::ranges::sort(items, {}, rock_of);
  return items;
}

void StoreObserver::save(ByteWriter& out) {
  settle();
  out.text(facts_ ? bytes_of(*facts_) : "");
  out.put(limit_.load());
  const std::vector<Item> items = in_order();
  out.count(items.size());
  for (const auto& [kept, cells, path] : items) {
    out.put(kept->rock);
    out.put(kept->rows);
    out.put(kept->cells_size);
    out.put(kept->path_size);
    out.numbers(std::span(cells));
    out.numbers(std::span(path));
  }
}

void StoreObserver::merge_saved(ByteReader& in) {
  const std::string facts = in.text();
  if (!facts.empty()) {
    ByteReader reader(facts);
    const StoreFacts theirs = StoreFacts::read(reader);
    reader.expect_end();
    expect_bytes(!facts_ || bytes_of(*facts_) == facts, "its trajectories are of another run");
    facts_ = theirs;
  }
  const auto limit = in.get<std::uint64_t>();
  constexpr std::size_t least_item = sizeof(std::uint64_t) + 3 * sizeof(std::uint32_t);
  std::size_t left = in.count(least_item);
  expect_bytes(left == 0 || facts_, "its trajectories are of an unknown run");
  constexpr std::size_t most_bytes = std::size_t{1} << 20;
  std::uint64_t next = 0;  // rock
  while (left > 0) {
    Block block;
    for (; left > 0 && block.paths.size() < most_bytes; --left) {
      Kept kept;
      kept.rock = in.get<std::uint64_t>();
      expect_bytes(kept.rock >= next && kept.rock < facts_->planned, "its trajectories are not in order");
      next = kept.rock + 1;
      kept.place = place_of(kept.rock);
      kept.rows = in.get<std::uint32_t>();
      kept.cells_size = in.get<std::uint32_t>();
      kept.path_size = in.get<std::uint32_t>();
      const std::string_view cells = in.bytes(kept.cells_size);
      ByteReader runs(cells);
      read_runs(runs, facts_->grid.count(), [](std::uint32_t, std::uint32_t) {});
      runs.expect_end();
      block.cells += cells;
      block.paths += in.bytes(kept.path_size);
      block.rocks.push_back(kept);
    }
    add(std::move(block));
  }
  if (std::min(limit, limit_.load()) != no_limit) drop_from(limit);
  settle();
}

StoreExtent StoreObserver::write(const std::filesystem::path& file, std::uint64_t done) {
  settle();
  StoreFile store(facts_.value_or(StoreFacts{}), done);
  const std::vector<Item> items = in_order();
  for (const auto& [kept, cells, path] : items) store.add(kept->rock, kept->rows, cells, path);
  return store.write(file);
}

}  // namespace talus
