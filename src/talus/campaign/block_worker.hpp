#pragma once
// The rocks that one process among several throws: blocks come and go while it works.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "talus/campaign/campaign.hpp"

namespace talus {

/// A block that observers have seen, and the rows that it adds to each table.
struct DoneBlock {
  RockRange rocks;
  std::vector<std::string> texts;
};

/// Throws blocks in threads of its own, so that the thread that has it can speak with other processes meanwhile.
class BlockWorker {
 public:
  /// `take_texts` gives the rows that were committed since it was last called. The model, the observers and what
  /// `take_texts` refers to must outlive the worker; they may be touched from outside while no block is under way.
  BlockWorker(const Model& model, std::vector<Observer*> observers, int threads,
              std::function<std::vector<std::string>()> take_texts);
  BlockWorker(const BlockWorker&) = delete;
  BlockWorker& operator=(const BlockWorker&) = delete;
  /// Finishes the blocks that were begun.
  ~BlockWorker();

  void give(const RockRange& rocks);
  /// Blocks that were done since the last call; where there are none it waits for one, up to so long. Throws what the
  /// work threw.
  [[nodiscard]] std::vector<DoneBlock> take(std::chrono::microseconds patience);

 private:
  [[nodiscard]] std::optional<RockRange> next();
  void finish(const RockRange& rocks);
  void close();

  std::function<std::vector<std::string>()> take_texts_;
  std::mutex mutex_;  // of all that follows but the thread
  std::condition_variable came_, done_changed_;
  std::deque<RockRange> waiting_;
  std::vector<DoneBlock> done_;
  bool is_closed_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace talus
