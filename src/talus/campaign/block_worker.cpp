#include "talus/campaign/block_worker.hpp"

#include <utility>

namespace talus {

BlockWorker::BlockWorker(const Model& model, std::vector<Observer*> observers, int threads,
                         std::function<std::vector<std::string>()> take_texts)
    : take_texts_(std::move(take_texts)) {
  thread_ = std::thread([this, &model, observers = std::move(observers), threads] {
    try {
      throw_blocks(model, observers, threads,
                   {[this] { return next(); }, [this](const RockRange& rocks) { finish(rocks); }, [this] { close(); }});
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      done_changed_.notify_all();
    }
  });
}

BlockWorker::~BlockWorker() {
  close();
  thread_.join();
}

void BlockWorker::give(const RockRange& rocks) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(rocks);
  came_.notify_one();
}

std::vector<DoneBlock> BlockWorker::take(std::chrono::microseconds patience) {
  std::unique_lock lock(mutex_);
  const auto is_ready = [&] { return !done_.empty() || failure_; };
  if (patience.count() > 0) done_changed_.wait_for(lock, patience, is_ready);
  if (failure_) std::rethrow_exception(failure_);
  return std::exchange(done_, {});
}

std::optional<RockRange> BlockWorker::next() {
  std::unique_lock lock(mutex_);
  came_.wait(lock, [&] { return is_closed_ || !waiting_.empty(); });
  if (is_closed_) return std::nullopt;
  const RockRange rocks = waiting_.front();
  waiting_.pop_front();
  return rocks;
}

void BlockWorker::finish(const RockRange& rocks) {
  DoneBlock block{rocks, take_texts_()};
  const std::lock_guard lock(mutex_);
  done_.push_back(std::move(block));
  done_changed_.notify_all();
}

void BlockWorker::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  came_.notify_all();
}

}  // namespace talus
