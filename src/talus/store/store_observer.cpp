#include "talus/store/store_observer.hpp"

#include <algorithm>
#include <utility>

#include "talus/store/path_code.hpp"
#include "talus/store/rock_choice.hpp"

namespace talus {

namespace {

/// Rocks are dropped once they exceed the budget by this share, so that it is not done for each block.
constexpr double most_excess = 0.125;

/// In the file, with its entries in the directory and the index.
std::uint64_t cost_of(const StoredRock& rock) {
  constexpr std::uint64_t directory_entry = 20;
  return rock.size() + directory_entry;
}

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
    if (!observer_.is_wanted(record.rock)) return;
    path_.clear();
    encoder_.encode(record, log, path_);
    const std::size_t before = bytes.size();
    put_runs(encoder_.cells(), bytes);
    rocks.push_back({.rock = record.rock,
                     .rows = static_cast<std::uint32_t>(log.rows.size()),
                     .cells_size = static_cast<std::uint32_t>(bytes.size() - before),
                     .path_size = static_cast<std::uint32_t>(path_.size())});
    bytes += path_;
  }

  std::vector<StoredRock> rocks;
  std::string bytes;  // of the rocks, one after the other

 private:
  const StoreObserver& observer_;
  PathEncoder encoder_;
  std::string path_;
};

StoreObserver::StoreObserver(const StoreBudget& budget, const Model& model)
    : budget_(budget), facts_(StoreFacts::of(model)) {}

std::uint64_t StoreObserver::place_of(std::uint64_t rock) const { return place_in_choice(facts_->seed, rock); }

bool StoreObserver::is_wanted(std::uint64_t rock) const {
  const std::uint64_t limit = limit_.load(std::memory_order_relaxed);
  return limit == no_limit || place_of(rock) < limit;
}

std::unique_ptr<ObserverPart> StoreObserver::new_part() const { return std::make_unique<Part>(*this); }

void StoreObserver::commit(ObserverPart& part) {
  auto& seen = static_cast<Part&>(part);
  const char* next = seen.bytes.data();
  for (StoredRock& rock : seen.rocks) {
    rock.bytes = next;
    next += rock.size();
    add(rock);
  }
  if (exceeds_budget(most_excess)) settle();
}

void StoreObserver::add(const StoredRock& rock) {
  rocks_.push_back(rock);
  rocks_.back().bytes = bytes_.add(rock.bytes, rock.size());
  cost_ += cost_of(rock);
}

void StoreObserver::drop_from(std::uint64_t place) {
  limit_ = std::min(limit_.load(), place);
  cost_ = 0;
  bytes_.rewind();
  std::erase_if(rocks_, [this](const StoredRock& rock) { return place_of(rock.rock) >= limit_; });
  for (StoredRock& rock : rocks_) {
    rock.bytes = bytes_.add(rock.bytes, rock.size());
    cost_ += cost_of(rock);
  }
}

bool StoreObserver::exceeds_budget(double share) const {
  const auto exceeds = [share](std::uint64_t size, std::uint64_t limit) {
    return static_cast<double>(size) > (1 + share) * static_cast<double>(limit);
  };
  return exceeds(cost_, budget_.bytes) || exceeds(rocks_.size(), budget_.rocks);
}

void StoreObserver::settle() {
  if (!exceeds_budget(0)) return;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> costs;  // by place
  costs.reserve(rocks_.size());
  for (const StoredRock& rock : rocks_) costs.emplace_back(place_of(rock.rock), cost_of(rock));
  std::ranges::sort(costs);
  std::uint64_t total = 0, rocks = 0;
  for (const auto& [place, cost] : costs) {
    total += cost;
    if (total > budget_.bytes || ++rocks > budget_.rocks) return drop_from(place);
  }
}

std::vector<StoredRock> StoreObserver::in_order() const {
  std::vector<StoredRock> rocks = rocks_;  // these stay as they are in memory
  if (!std::ranges::is_sorted(rocks, {}, &StoredRock::rock)) std::ranges::sort(rocks, {}, &StoredRock::rock);
  return rocks;
}

void StoreObserver::save(ByteWriter& out) {
  settle();
  out.text(facts_ ? bytes_of(*facts_) : "");
  out.put(limit_.load());
  const std::vector<StoredRock> rocks = in_order();
  out.count(rocks.size());
  for (const StoredRock& rock : rocks) {
    out.put(rock.rock);
    out.put(rock.rows);
    out.put(rock.cells_size);
    out.put(rock.path_size);
    out.numbers(std::span(rock.bytes, rock.size()));
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
  std::uint64_t next = 0;  // rock
  for (; left > 0; --left) {
    StoredRock rock;
    rock.rock = in.get<std::uint64_t>();
    expect_bytes(rock.rock >= next && rock.rock < facts_->planned, "its trajectories are not in order");
    next = rock.rock + 1;
    rock.rows = in.get<std::uint32_t>();
    rock.cells_size = in.get<std::uint32_t>();
    rock.path_size = in.get<std::uint32_t>();
    const std::string_view bytes = in.bytes(rock.size());
    rock.bytes = bytes.data();
    ByteReader runs(rock.cells());
    read_runs(runs, facts_->grid.count(), [](std::uint32_t, std::uint32_t) {});
    runs.expect_end();
    add(rock);
  }
  if (std::min(limit, limit_.load()) != no_limit) drop_from(limit);
  settle();
}

StoreExtent StoreObserver::write(const std::filesystem::path& file, std::uint64_t done) {
  settle();
  return write_store(file, facts_.value_or(StoreFacts{}), done, in_order());
}

}  // namespace talus
