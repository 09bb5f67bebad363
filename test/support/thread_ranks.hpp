#pragma once
// Ranks that are threads of one process, which exchange the same messages without MPI.

#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "talus/campaign/ranks.hpp"

namespace talus::testing_tools {

class ThreadRanks {
 public:
  explicit ThreadRanks(int size) : boxes_(static_cast<std::size_t>(size)) {}

  /// One rank, to be used by one thread.
  class One : public Ranks {
   public:
    One(ThreadRanks& all, int rank) : all_(all), rank_(rank) {}
    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return static_cast<int>(all_.boxes_.size()); }
    [[nodiscard]] std::string machine() const override { return "machine " + std::to_string(rank_); }
    [[nodiscard]] int threads() const override { return 1; }
    void send(int to, std::string bytes) override {
      const std::lock_guard lock(all_.mutex_);
      all_.boxes_[static_cast<std::size_t>(to)].push_back({rank_, std::move(bytes)});
    }
    [[nodiscard]] std::optional<Message> receive() override {
      const std::lock_guard lock(all_.mutex_);
      auto& box = all_.boxes_[static_cast<std::size_t>(rank_)];
      if (box.empty()) return std::nullopt;
      Message message = std::move(box.front());
      box.pop_front();
      return message;
    }
    [[nodiscard]] std::size_t unsent() override { return 0; }

   private:
    ThreadRanks& all_;
    int rank_;
  };

 private:
  std::mutex mutex_;
  std::vector<std::deque<Ranks::Message>> boxes_;
};

/// Runs `first` as rank 0 in this thread, and `other` as each of the other ranks in threads of their own.
inline void with_ranks(int size, const std::function<void(Ranks&)>& first, const std::function<void(Ranks&)>& other) {
  ThreadRanks all(size);
  std::vector<std::jthread> threads;
  for (int rank = 1; rank < size; ++rank) {
    threads.emplace_back([&all, &other, rank] {
      ThreadRanks::One one(all, rank);
      other(one);
    });
  }
  ThreadRanks::One one(all, 0);
  first(one);
}

}  // namespace talus::testing_tools
