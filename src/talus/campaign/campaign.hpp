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
  const std::atomic<bool>* stop = nullptr;  // set from outside: blocks begun are finished, no more are begun
  /// Called with the number that follows the last rock done, by one thread at a time and each time that all observers
  /// have seen exactly the rocks before it. What it throws ends the campaign.
  std::function<void(std::uint64_t)> progress;
  std::optional<RockRange> rocks;  // of the model's; nothing: all of them
};

struct CampaignOutcome {
  std::uint64_t done = 0;  // the range's rocks up to done - 1 were computed
  bool interrupted = false;
  double seconds = 0;
  int threads = 1;
};

CampaignOutcome run_campaign(const Model& model, std::span<Observer* const> observers, const CampaignOptions& options);

}  // namespace talus
