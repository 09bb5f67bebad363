#include "talus/run/run_on_ranks.hpp"

#include <fmt/format.h>

#include <map>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "talus/archive/table_texts.hpp"
#include "talus/campaign/block_counter.hpp"
#include "talus/core/stop.hpp"
#include "talus/run/rank_messages.hpp"

namespace talus::project {

namespace {

constexpr int bad_input = 2;  // the exit code of BadInput

std::string name_of(int rank, const std::string& machine) { return fmt::format("rank {} on {}", rank, machine); }

/// The errors of another rank, with the rank and its machine in front of each line.
Problems problems_of(int rank, const Cannot& cannot) {
  Problems problems;
  std::string_view left = cannot.text;
  while (!left.empty()) {
    const std::size_t end = std::min(left.find('\n'), left.size());
    problems.add({.where = name_of(rank, cannot.machine), .what = std::string(left.substr(0, end))});
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return problems;
}

[[noreturn]] void throw_failure_of_rank(int rank, const Cannot& cannot) {
  if (cannot.exit_code == bad_input) throw BadInput(problems_of(rank, cannot));
  throw std::runtime_error(name_of(rank, cannot.machine) + ": " + cannot.text);
}

std::optional<std::string> what_differs(const Hello& theirs, const RunDescription& ours) {
  if (theirs.version == TALUS_VERSION) return difference(ours, theirs.description);
  return fmt::format("talus {} runs there, and {} here", theirs.version, TALUS_VERSION);
}

/// The work of rank 0: hands out blocks, orders those that come back, and gathers the sums at intervals.
class Coordinator {
 public:
  Coordinator(Ranks& ranks, std::span<const int> threads, const Model& model, const RunOptions& options,
              const RunStateHeader& begun, RunSums& sums, TableFiles& tables, TableTexts& texts,
              Checkpoints& checkpoints)
      : ranks_(ranks),
        options_(options),
        range_(begun.range),
        all_sums_(sums),
        sums_(sums.observers()),
        tables_(tables),
        checkpoints_(checkpoints),
        counter_({begun.done, begun.range.last}, threads),
        order_(begun.done),
        worker_(model, texts.observers(), sums_, threads[0], [&texts] { return texts.take(); }),
        helpers_at_work_(ranks.size() - 1) {}

  /// Returns the rock after the last one done.
  std::uint64_t run() {
    while (true) {
      while (const auto message = ranks_.receive()) {
        naps_.found_something();
        handle(*message);
      }
      for (DoneBlock& block : worker_.take(naps_.next(ranks_))) {
        naps_.found_something();
        came_back(0, std::move(block));
      }
      write_in_order();
      if (all_sums_.lacking_memory()) throw std::bad_alloc();
      if (!is_stopping_ && (is_asked_to_stop_ || is_requested(options_.campaign.stop))) stop();
      if (is_stopping_) {
        if (!worker_.has_ended() || helpers_at_work_ > 0) continue;
        gather();
        return order_.next_rock();
      }
      if (!pause_began_ && counter_.left() > 0 && checkpoints_.is_due()) pause_began_ = Checkpoints::Clock::now();
      if (!pause_began_) hand_out();
      if (!counter_.is_quiet()) continue;
      const bool is_end = counter_.left() == 0;
      if (!is_end && !pause_began_) continue;
      gather();
      if (is_end) return order_.next_rock();
      checkpoints_.write(order_.next_rock(), *pause_began_);
      pause_began_.reset();
    }
  }

 private:
  /// The limit for rows that wait for earlier ones: above it no blocks are handed out. The missing ones are under way
  /// already.
  static constexpr std::size_t most_waiting_bytes = std::size_t{256} << 20;

  void handle(const Ranks::Message& message) {
    switch (kind_of(message)) {
      case MessageKind::block:
        came_back(message.from, block_from(content_of(message)));
        break;
      case MessageKind::stop:
        is_asked_to_stop_ = true;
        break;
      case MessageKind::stopped:
        --helpers_at_work_;
        break;
      case MessageKind::cannot:
        throw_failure_of_rank(message.from, cannot_from(content_of(message)));
      default:
        throw BadBytes(fmt::format("rank {} sent a message that only rank 0 may send", message.from));
    }
  }

  void came_back(int from, DoneBlock block) {
    const auto rank = static_cast<std::size_t>(from);
    counter_.came_back(rank, block.rocks.count());
    order_.add({rank, std::move(block)});
  }

  void write_in_order() {
    std::set<int> waiting;  // helpers whose blocks are in order now
    while (auto next = order_.next()) {
      auto& [rank, block] = *next;
      tables_.append(block.texts);
      counter_.is_in_order(rank);
      if (rank == 0) {
        commit(block, sums_);
      } else {
        waiting.insert(static_cast<int>(rank));
      }
      if (options_.campaign.progress) options_.campaign.progress(block.rocks.last - range_.first);
    }
    for (const int rank : waiting) ranks_.send(rank, done_message(order_.next_rock()));
  }

  void stop() {
    is_stopping_ = true;
    worker_.stop();
    for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, message_of(MessageKind::stop));
  }

  /// One block per rank and round, so that all ranks get some even if there are few.
  void hand_out() {
    for (bool is_more = true; is_more;) {
      is_more = false;
      for (int rank = 0; rank < ranks_.size(); ++rank) {
        if (order_.bytes() > most_waiting_bytes) return;
        const auto rocks = counter_.take(static_cast<std::size_t>(rank));
        if (!rocks) continue;
        is_more = true;
        if (rank == 0) {
          worker_.give(*rocks);
        } else {
          ranks_.send(rank, message_of(*rocks));
        }
      }
    }
  }

  void gather() {
    for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, message_of(MessageKind::gather));
    gather_sums(ranks_, inbox_, sums_, [&](const Ranks::Message& message) { handle(message); });
  }

  Ranks& ranks_;
  const RunOptions& options_;
  RockRange range_;
  const RunSums& all_sums_;
  std::vector<SummingObserver*> sums_;
  TableFiles& tables_;
  Checkpoints& checkpoints_;
  BlockCounter counter_;
  BlockOrder order_;
  GatherInbox inbox_;
  Naps naps_;
  bool is_asked_to_stop_ = false;  // by a helper
  bool is_stopping_ = false;
  std::optional<Checkpoints::Clock::time_point> pause_began_;  // no blocks are handed out until a checkpoint is written
  BlockWorker worker_;
  int helpers_at_work_;  // helpers that have not stopped
};

}  // namespace

std::vector<int> meet_ranks(Ranks& ranks, const RunDescription& description, int own_threads) {
  std::vector<int> threads(static_cast<std::size_t>(ranks.size()), 1);
  threads[0] = own_threads > 0 ? own_threads : ranks.threads();
  std::map<int, Problems> problems;  // in the order of the ranks
  Naps naps;
  for (int expected = ranks.size() - 1; expected > 0;) {
    stop_point();
    const auto message = ranks.receive();
    if (!message) {
      std::this_thread::sleep_for(naps.next(ranks));
      continue;
    }
    const MessageKind kind = kind_of(*message);
    if (kind == MessageKind::stop) throw Stopped{};
    --expected;
    if (kind == MessageKind::cannot) {
      const Cannot cannot = cannot_from(content_of(*message));
      if (cannot.exit_code != bad_input) throw_failure_of_rank(message->from, cannot);
      problems[message->from].append(problems_of(message->from, cannot));
      continue;
    }
    expect_bytes(kind == MessageKind::hello, "the first message of a rank is not hello");
    const Hello hello = hello_from(content_of(*message));
    threads[static_cast<std::size_t>(message->from)] = hello.threads;
    if (const auto why = what_differs(hello, description)) {
      problems[message->from].add({.where = name_of(message->from, hello.machine),
                                   .what = "this rank would not compute the same results as the others",
                                   .why = *why,
                                   .hint = "Give all ranks the same command, the same files and the same program, on "
                                           "machines of one kind; or run each alone (--alone)"});
    }
  }
  Problems all;
  for (const auto& [rank, each] : problems) all.append(each);
  if (all.has_errors()) throw BadInput(std::move(all));
  return threads;
}

CampaignOutcome simulate_on_ranks(Ranks& ranks, std::span<const int> threads, const Project& project,
                                  const Model& model, const RunOptions& options, const RunStateHeader& begun,
                                  RunSums& sums, TableFiles& tables, Checkpoints& checkpoints) {
  const auto begin = std::chrono::steady_clock::now();
  TableTexts texts(TableContext::of(model), table_rocks(project, model.rocks()));
  CampaignOutcome outcome;
  outcome.done = Coordinator(ranks, threads, model, options, begun, sums, tables, texts, checkpoints).run();
  outcome.interrupted = outcome.done < begun.range.last;
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.threads = 0;
  for (const int each : threads) outcome.threads += each;
  outcome.ranks = ranks.size();
  return outcome;
}

void dismiss_ranks(Ranks& ranks, int exit_code) {
  for (int rank = 1; rank < ranks.size(); ++rank) ranks.send(rank, leave_message(exit_code));
}

}  // namespace talus::project
