// The work of all ranks but rank 0.

#include <deque>
#include <optional>
#include <stdexcept>
#include <thread>

#include "talus/archive/table_texts.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"
#include "talus/run/rank_messages.hpp"
#include "talus/run/run_on_ranks.hpp"

namespace talus::project {

namespace {

constexpr int rank_0 = 0;

/// Thrown when rank 0 dismisses this rank, whatever it is doing.
struct Dismissed {
  int exit_code;
};

/// What a rank accumulates between two gatherings of sums.
struct Work {
  Work(const RunDescription& description, const Project& project, const Model& model, int threads)
      : sums(description, project, model),
        texts(TableContext::of(model), table_rocks(project, model.rocks())),
        list(sums.observers()),
        worker(model, texts.observers(), list, threads, [this] { return texts.take(); }) {}

  /// Adds the finished blocks before this rock to the sums; none is missing between them.
  void add_before(std::uint64_t next_rock) {
    for (; !held.empty() && held.front().rocks.last <= next_rock; held.pop_front()) commit(held.front(), list);
  }

  RunSums sums;
  TableTexts texts;
  std::vector<SummingObserver*> list;
  std::deque<DoneBlock> held;  // not yet in the sums; their rows were sent
  BlockWorker worker;
};

class Helper {
 public:
  Helper(Ranks& ranks, const RunDescription& description, const Project& project, const Model& model, int threads,
         const RunOptions& options)
      : ranks_(ranks),
        description_(description),
        project_(project),
        model_(model),
        threads_(threads),
        maps_memory_(options.maps_memory),
        stop_(options.campaign.stop) {}

  [[noreturn]] void run() {
    while (true) {
      while (const auto message = ranks_.receive()) {
        naps_.found_something();
        handle(*message);
      }
      if (work_) {
        for (DoneBlock& block : work_->worker.take(naps_.next(ranks_))) {
          naps_.found_something();
          ranks_.send(rank_0, message_of(block));
          block.texts.clear();
          work_->held.push_back(std::move(block));
        }
        if (is_stopping_ && !has_sent_stopped_ && work_->worker.has_ended()) say_stopped();
        if (const auto lacks = work_->sums.lacking_memory()) throw OutOfMemory(*lacks);
      } else {
        std::this_thread::sleep_for(naps_.next(ranks_));
      }
      if (!has_sent_stop_ && is_requested(stop_)) {
        ranks_.send(rank_0, message_of(MessageKind::stop));
        has_sent_stop_ = true;
      }
    }
  }

 private:
  void handle(const Ranks::Message& message) {
    if (inbox_.add(message)) return;
    switch (kind_of(message)) {
      case MessageKind::rocks:
        work().worker.give(rocks_from(content_of(message)));
        break;
      case MessageKind::done:
        if (work_) work_->add_before(next_rock_from(content_of(message)));
        break;
      case MessageKind::gather:
        gather_sums(ranks_, inbox_, work().list, [&](const Ranks::Message& other) { handle(other); });
        work_.reset();
        break;
      case MessageKind::stop:
        is_stopping_ = true;
        if (work_) {
          work_->worker.stop();
        } else {
          say_stopped();
        }
        break;
      case MessageKind::leave:
        throw Dismissed{exit_code_from(content_of(message))};
      default:
        throw BadBytes("rank 0 sent a message that only other ranks may send");
    }
  }

  void say_stopped() {
    ranks_.send(rank_0, message_of(MessageKind::stopped));
    has_sent_stopped_ = true;
  }

  Work& work() {
    if (work_) return *work_;
    work_ = std::make_unique<Work>(description_, project_, model_, threads_);
    work_->sums.limit_maps_memory(maps_memory_);
    return *work_;
  }

  Ranks& ranks_;
  const RunDescription& description_;
  const Project& project_;
  const Model& model_;
  int threads_;
  std::uint64_t maps_memory_;
  const std::atomic<bool>* stop_;
  Naps naps_;
  bool has_sent_stop_ = false;                           // to rank 0: a stop was requested here
  bool is_stopping_ = false, has_sent_stopped_ = false;  // at the request of rank 0
  GatherInbox inbox_;
  std::unique_ptr<Work> work_;  // created when there is work
};

}  // namespace

namespace {

int wait_for_leave(Ranks& ranks) {
  for (Naps naps;;) {
    const auto message = ranks.receive();
    if (!message) std::this_thread::sleep_for(naps.next(ranks));
    if (message && kind_of(*message) == MessageKind::leave) return exit_code_from(content_of(*message));
  }
}

}  // namespace

int help_run(Ranks& ranks, const Project& project, const Model& model, const Problems& warnings,
             const RunOptions& options) {
  try {
    const int threads = options.campaign.threads > 0 ? options.campaign.threads : ranks.threads();
    std::optional<StopScope> beginning(std::in_place, options.campaign.stop);
    const RunDescription description = describe_run(project, model, warnings, options.shard);
    beginning.reset();
    ranks.send(rank_0, message_of(Hello{TALUS_VERSION, ranks.machine(), threads, description}));
    Helper(ranks, description, project, model, threads, options).run();
  } catch (const Stopped&) {
    ranks.send(rank_0, message_of(MessageKind::stop));
    return wait_for_leave(ranks);
  } catch (const Dismissed& dismissed) {
    return dismissed.exit_code;
  }
}

int cannot_help(Ranks& ranks, const std::string& what, int exit_code) {
  ranks.send(rank_0, message_of(Cannot{ranks.machine(), what, exit_code}));
  return wait_for_leave(ranks);
}

}  // namespace talus::project
