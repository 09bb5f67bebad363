#pragma once
// Simulates the rocks of one process among several: blocks are added and returned while it works.

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

/// A finished block: the rows that it adds to each table, and its contribution to each sum.
struct DoneBlock {
  RockRange rocks;
  std::vector<std::string> texts;
  std::vector<std::unique_ptr<ObserverPart>> parts{};  // to be committed when no rock before the block is missing
};

/// Adds a block's contributions to the sums that it was made for.
void commit(DoneBlock& block, std::span<SummingObserver* const> sums);

/// Simulates blocks in its own threads, so that the owner's thread can exchange messages with other processes
/// meanwhile.
class BlockWorker {
 public:
  /// `take_texts` returns the rows committed to the tables since its last call. The model, the observers and what
  /// `take_texts` refers to must outlive the worker. Others may use the tables only while no block is in progress.
  /// Nothing is committed to the sums here; others may do so at any time.
  BlockWorker(const Model& model, const std::vector<Observer*>& tables, const std::vector<SummingObserver*>& sums,
              int threads, std::function<std::vector<std::string>()> take_texts);
  BlockWorker(const BlockWorker&) = delete;
  BlockWorker& operator=(const BlockWorker&) = delete;
  /// Drops the blocks in progress.
  ~BlockWorker();

  void give(const RockRange& rocks);
  /// Blocks finished since the last call, in the order in which they were given. If there are none, it waits for one,
  /// at most `patience`. Rethrows what the work threw.
  [[nodiscard]] std::vector<DoneBlock> take(std::chrono::microseconds patience);
  /// Drops the rocks in progress and starts no more. The first block that was interrupted is still returned, with the
  /// rocks before the interruption; the blocks after it are not.
  void stop();
  /// After stop(): whether nothing is in progress any more, and all finished blocks have been taken.
  [[nodiscard]] bool has_ended();

 private:
  [[nodiscard]] std::optional<RockRange> next();
  void finish(const RockRange& rocks);
  void close();

  class Held;

  std::function<std::vector<std::string>()> take_texts_;
  std::vector<std::unique_ptr<Held>> sums_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  // for all that follows except the thread
  std::condition_variable came_, done_changed_;
  std::deque<RockRange> waiting_;
  std::vector<DoneBlock> done_;
  bool is_closed_ = false, has_ended_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace talus
