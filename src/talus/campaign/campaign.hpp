#pragma once
// Simulates all rocks of a model on all cores. Results do not depend on the number of threads or on the order in which
// rocks are computed: rocks are handed out in blocks, and committed to the observers in their order.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/results/record.hpp"

namespace talus {

struct CampaignOptions {
  int threads = 0;                          // 0: as many as there are cores
  const std::atomic<bool>* stop = nullptr;  // set by the caller: rocks in progress are dropped, no more are started
  /// Called with a rock's number each time that all observers have seen exactly the rocks before it; by one thread at a
  /// time. An exception from it ends the campaign.
  std::function<void(std::uint64_t)> progress;
  std::optional<RockRange> rocks;  // nullopt: all rocks of the model
};

struct CampaignOutcome {
  std::uint64_t done = 0;  // the range's rocks up to done - 1 were computed
  bool interrupted = false;
  double seconds = 0;
  int threads = 1;  // of all ranks together
  int ranks = 1;
};

CampaignOutcome run_campaign(const Model& model, std::span<Observer* const> observers, const CampaignOptions& options);

/// Where blocks of rocks come from, in any order, and who is informed about them.
struct BlockFlow {
  /// The next block; nullopt if there will be no more. May wait. Called by one thread at a time.
  std::function<std::optional<RockRange>()> next;
  /// Observers have seen these rocks, and no others since the last call. Called for blocks in the order of `next`, by
  /// one thread at a time. After a stop, the last block is without the rocks that were dropped.
  std::function<void(const RockRange&)> committed;
  /// The work ends with an exception: a `next` that waits must return. Called by any thread, at any time.
  std::function<void()> failed;
  /// Set by the caller: rocks in progress are dropped, and no rock after one of them is committed. Null: never.
  const std::atomic<bool>* stop = nullptr;
};

/// Simulates blocks until there are no more.
void simulate_blocks(const Model& model, std::span<Observer* const> observers, int threads, const BlockFlow& flow);

/// `requested` threads; 0: as many as there are cores for this process.
[[nodiscard]] int threads_for(int requested);

}  // namespace talus
