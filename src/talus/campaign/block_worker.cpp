#include "talus/campaign/block_worker.hpp"

#include <utility>

#include "talus/core/check.hpp"

namespace talus {

/// Keeps the part of an observer that is to be committed later.
class BlockWorker::Held : public Observer {
 public:
  explicit Held(const SummingObserver& observer) : observer_(observer) {}
  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override { return observer_.wants_rows(rock); }
  [[nodiscard]] bool wants_pieces() const override { return observer_.wants_pieces(); }
  [[nodiscard]] bool wants_impacts(std::uint64_t rock) const override { return observer_.wants_impacts(rock); }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override {
    return std::make_unique<Part>(observer_.new_part());
  }
  void commit(ObserverPart& part) override { last_ = std::move(static_cast<Part&>(part).part); }
  /// The part committed here since the last call.
  [[nodiscard]] std::unique_ptr<ObserverPart> take() { return std::move(last_); }

 private:
  struct Part : ObserverPart {
    explicit Part(std::unique_ptr<ObserverPart> of) : part(std::move(of)) {}
    void see(const RockRecord& record, const RockLog& log) override { part->see(record, log); }
    std::unique_ptr<ObserverPart> part;
  };

  const SummingObserver& observer_;
  std::unique_ptr<ObserverPart> last_;
};

void commit(DoneBlock& block, std::span<SummingObserver* const> sums) {
  TALUS_PROMISE(block.parts.size() == sums.size(), "a block has a part of each sum");
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k]->commit(*block.parts[k]);
  block.parts.clear();
}

BlockWorker::BlockWorker(const Model& model, const std::vector<Observer*>& tables,
                         const std::vector<SummingObserver*>& sums, int threads,
                         std::function<std::vector<std::string>()> take_texts)
    : take_texts_(std::move(take_texts)) {
  std::vector<Observer*> observers = tables;
  for (const SummingObserver* sum : sums) {
    observers.push_back(sums_.emplace_back(std::make_unique<Held>(*sum)).get());
  }
  thread_ = std::thread([this, &model, observers = std::move(observers), threads] {
    std::exception_ptr failure;
    try {
      simulate_blocks(
          model, observers, threads,
          {[this] { return next(); }, [this](const RockRange& rocks) { finish(rocks); }, [this] { close(); }, &stop_});
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    failure_ = failure;
    has_ended_ = true;
    done_changed_.notify_all();
  });
}

BlockWorker::~BlockWorker() {
  stop();
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

void BlockWorker::stop() {
  stop_ = true;
  close();
}

bool BlockWorker::has_ended() {
  const std::lock_guard lock(mutex_);
  return has_ended_ && done_.empty();
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
  DoneBlock block{rocks, take_texts_(), {}};
  for (const auto& sum : sums_) block.parts.push_back(sum->take());
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
