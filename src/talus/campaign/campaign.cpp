#include "talus/campaign/campaign.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <chrono>

#include "talus/campaign/simulate.hpp"

namespace talus {

namespace {

// Large enough that handing out and committing cost nothing, small enough that all paths of the blocks under way fit
// in memory (about 2 MB a block) and that a short campaign keeps every core busy to the end.
constexpr std::uint64_t rocks_a_block = 256;

struct Block {
  std::uint64_t first = 0, last = 0;
  std::vector<std::unique_ptr<ObserverPart>> parts;
};

}  // namespace

CampaignOutcome run_campaign(const Model& model, std::span<Observer* const> observers, const CampaignOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::enumerable_thread_specific<Simulator> simulators([&] { return Simulator(model); });

  bool pieces = false;
  for (const Observer* observer : observers) pieces = pieces || observer->wants_pieces();

  CampaignOutcome outcome;
  outcome.threads = threads;
  const RockRange range = options.rocks.value_or(RockRange{0, model.rocks()});
  std::uint64_t next = outcome.done = range.first;
  using BlockPointer = std::shared_ptr<Block>;
  const auto hand_out = [&](tbb::flow_control& control) -> BlockPointer {
    if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed))
      outcome.interrupted = next < range.last;
    if (outcome.interrupted || next == range.last) {
      control.stop();
      return nullptr;
    }
    auto block = std::make_shared<Block>();
    block->first = next;
    block->last = next = std::min(range.last, next + rocks_a_block);
    return block;
  };
  const auto compute = [&](BlockPointer block) {
    for (const Observer* observer : observers) block->parts.push_back(observer->new_part());
    SimulationOrder order;
    order.rocks = {block->first, block->last};
    order.keep_rows = [&](std::uint64_t rock) {
      return std::any_of(observers.begin(), observers.end(), [&](const Observer* o) { return o->wants_rows(rock); });
    };
    order.keep_pieces = pieces;
    order.see = [&](const RockRecord& record, const RockLog& log) {
      for (const auto& part : block->parts) part->see(record, log);
    };
    simulators.local().simulate(order);
    return block;
  };
  const auto commit = [&](const BlockPointer& block) {
    for (std::size_t k = 0; k < observers.size(); ++k) observers[k]->commit(*block->parts[k]);
    outcome.done = block->last;
    if (options.progress) options.progress(outcome.done);
  };
  tbb::parallel_pipeline(static_cast<std::size_t>(threads) * 2,
                         tbb::make_filter<void, BlockPointer>(tbb::filter_mode::serial_in_order, hand_out) &
                             tbb::make_filter<BlockPointer, BlockPointer>(tbb::filter_mode::parallel, compute) &
                             tbb::make_filter<BlockPointer, void>(tbb::filter_mode::serial_in_order, commit));
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace talus
