#pragma once
// All rocks of a model, on all cores. Results do not depend on the number of threads or on the order in which rocks
// are computed: rocks are handed out in blocks, and observers see the blocks in the order of the rocks.

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
  const std::atomic<bool>* stop = nullptr;  // set from outside: rocks on their way are left, no more are begun
  /// Called with the number that follows the last rock done, by one thread at a time and each time that all observers
  /// have seen exactly the rocks before it. What it throws ends the campaign.
  std::function<void(std::uint64_t)> progress;
  std::optional<RockRange> rocks;  // of the model's; nothing: all of them
};

struct CampaignOutcome {
  std::uint64_t done = 0;  // the range's rocks up to done - 1 were computed
  bool interrupted = false;
  double seconds = 0;
  int threads = 1;  // of all ranks together
  int ranks = 1;
};

CampaignOutcome run_campaign(const Model& model, std::span<Observer* const> observers, const CampaignOptions& options);

/// Blocks of rocks that come from elsewhere, in any order.
struct BlockFlow {
  /// The next block; nothing if there will be no more. It may wait. Called by one thread at a time.
  std::function<std::optional<RockRange>()> next;
  /// Observers have seen these rocks, and none other since the last call. Blocks come here in the order in which they
  /// came from `next`; the last one without the rocks that were left, where it was stopped. Called by one thread at a
  /// time.
  std::function<void(const RockRange&)> committed;
  /// The work ends with an exception, for which `next` must not keep it waiting. By any thread, at any time.
  std::function<void()> failed;
  /// Set from outside: rocks on their way are left, and nothing is committed that comes after one. Null: nobody asks.
  const std::atomic<bool>* stop = nullptr;
};

/// Throws blocks until there are no more.
void simulate_blocks(const Model& model, std::span<Observer* const> observers, int threads, const BlockFlow& flow);

/// 0: as many as there are cores for this process.
[[nodiscard]] int threads_for(int asked);

}  // namespace talus
