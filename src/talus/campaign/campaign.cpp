#include "talus/campaign/campaign.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>

#include "talus/campaign/block_size.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus {

namespace {

struct Block {
  RockRange rocks;  // for the observers
  std::vector<std::unique_ptr<ObserverPart>> parts;
  bool is_cut = false;  // stopped before its last rock
};

}  // namespace

int threads_for(int requested) { return requested > 0 ? requested : tbb::info::default_concurrency(); }

void simulate_blocks(const Model& model, std::span<Observer* const> observers, int threads, const BlockFlow& flow) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::enumerable_thread_specific<Simulator> simulators([&] { return Simulator(model); });

  bool pieces = false;
  for (const Observer* observer : observers) pieces = pieces || observer->wants_pieces();

  // In the order of the rocks. (After an exception the pipeline drops the pointers in it, so that blocks are owned
  // here.)
  std::deque<std::unique_ptr<Block>> in_progress;
  std::mutex in_progress_mutex;
  const auto hand_out = [&](tbb::flow_control& control) -> Block* {
    const std::optional<RockRange> rocks = flow.next();
    if (!rocks) {
      control.stop();
      return nullptr;
    }
    const std::lock_guard lock(in_progress_mutex);
    return in_progress.emplace_back(std::make_unique<Block>(Block{*rocks, {}, false})).get();
  };
  const auto compute = [&](Block* block) {
    try {
      for (const Observer* observer : observers) block->parts.push_back(observer->new_part());
      SimulationOrder order;
      order.rocks = block->rocks;
      order.keep_rows = [&](std::uint64_t rock) {
        return std::any_of(observers.begin(), observers.end(), [&](const Observer* o) { return o->wants_rows(rock); });
      };
      order.keep_impacts = [&](std::uint64_t rock) {
        return std::any_of(observers.begin(), observers.end(),
                           [&](const Observer* o) { return o->wants_impacts(rock); });
      };
      order.keep_pieces = pieces;
      order.see = [&](const RockRecord& record, const RockLog& log) {
        for (const auto& part : block->parts) part->see(record, log);
      };
      const StopScope scope(flow.stop);
      order.stop = &scope;
      const std::uint64_t next = simulators.local().simulate(order);
      block->is_cut = next < block->rocks.last;
      block->rocks.last = next;
    } catch (const Stopped&) {  // thrown by an observer
      block->is_cut = true;
      block->rocks.last = block->rocks.first;
    } catch (...) {
      if (flow.failed) flow.failed();
      throw;
    }
    return block;
  };
  bool is_cut = false;
  const auto commit = [&](Block* block) {
    try {
      if (!is_cut && block->rocks.count() > 0) {
        for (std::size_t k = 0; k < observers.size(); ++k) observers[k]->commit(*block->parts[k]);
        flow.committed(block->rocks);
      }
      is_cut = is_cut || block->is_cut;
      const std::lock_guard lock(in_progress_mutex);
      in_progress.pop_front();
    } catch (...) {
      if (flow.failed) flow.failed();
      throw;
    }
  };
  tbb::parallel_pipeline(static_cast<std::size_t>(threads) * 2,
                         tbb::make_filter<void, Block*>(tbb::filter_mode::serial_in_order, hand_out) &
                             tbb::make_filter<Block*, Block*>(tbb::filter_mode::parallel, compute) &
                             tbb::make_filter<Block*, void>(tbb::filter_mode::serial_in_order, commit));
}

CampaignOutcome run_campaign(const Model& model, std::span<Observer* const> observers, const CampaignOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  CampaignOutcome outcome;
  outcome.threads = threads_for(options.threads);
  const RockRange range = options.rocks.value_or(RockRange{0, model.rocks()});
  std::uint64_t next = outcome.done = range.first;
  BlockFlow flow;
  flow.stop = options.stop;
  BlockSize size(outcome.threads);
  std::mutex size_mutex;
  flow.next = [&]() -> std::optional<RockRange> {
    if (is_requested(options.stop) || next == range.last) return std::nullopt;
    const std::lock_guard lock(size_mutex);
    const std::uint64_t first = next;
    next = std::min(range.last, next + std::min(size.next(), range.last - next));
    return RockRange{first, next};
  };
  flow.committed = [&](const RockRange& rocks) {
    outcome.done = rocks.last;
    {
      const std::lock_guard lock(size_mutex);
      size.done(rocks.count());
    }
    if (options.progress) options.progress(outcome.done);
  };
  simulate_blocks(model, observers, outcome.threads, flow);
  outcome.interrupted = outcome.done < range.last;
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace talus
