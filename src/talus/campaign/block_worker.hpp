#pragma once
// The rocks that one process among several throws: blocks come and go while it works.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "talus/campaign/campaign.hpp"

namespace talus {

/// A block that observers have seen: the rows that it adds to each table, and what it adds to each sum.
struct DoneBlock {
  RockRange rocks;
  std::vector<std::string> texts;
  std::vector<std::unique_ptr<ObserverPart>> parts{};  // not committed: that is for who knows that no rock is missing
};

/// Adds what a block holds to the sums that it was made for.
void commit(DoneBlock& block, std::span<SummingObserver* const> sums);

/// Throws blocks in threads of its own, so that the thread that has it can speak with other processes meanwhile.
class BlockWorker {
 public:
  /// `take_texts` gives the rows that were committed to the tables since it was last called. The model, the observers
  /// and what `take_texts` refers to must outlive the worker. The tables may be touched from outside while no block is
  /// under way; nothing is committed to the sums here, and others may do so at any time.
  BlockWorker(const Model& model, const std::vector<Observer*>& tables, const std::vector<SummingObserver*>& sums,
              int threads, std::function<std::vector<std::string>()> take_texts);
  BlockWorker(const BlockWorker&) = delete;
  BlockWorker& operator=(const BlockWorker&) = delete;
  /// Leaves the blocks that were begun.
  ~BlockWorker();

  void give(const RockRange& rocks);
  /// Blocks that were done since the last call, in the order in which they were given; where there are none it waits
  /// for one, up to so long. Throws what the work threw.
  [[nodiscard]] std::vector<DoneBlock> take(std::chrono::microseconds patience);
  /// Rocks on their way are left, and no more are begun. Of the first block that was left the rocks before that place
  /// are still given, of those after it none.
  void stop();
  /// After stop(): nothing is under way any more, and all that was done has been taken.
  [[nodiscard]] bool has_ended();

 private:
  [[nodiscard]] std::optional<RockRange> next();
  void finish(const RockRange& rocks);
  void close();

  class Held;

  std::function<std::vector<std::string>()> take_texts_;
  std::vector<std::unique_ptr<Held>> sums_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  // of all that follows but the thread
  std::condition_variable came_, done_changed_;
  std::deque<RockRange> waiting_;
  std::vector<DoneBlock> done_;
  bool is_closed_ = false, has_ended_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace talus
