#pragma once
// What the ranks of a run say to each other. Rank 0 counts out the rocks and writes the results; the others are its
// helpers:
//
//   helper to rank 0     hello: it has read the project, and what it made of it
//   rank 0 to helpers    rocks: a block to throw; each has a few before it (campaign/block_counter.hpp)
//   helper to rank 0     block: the rows of its tables; what it adds to the sums is kept until
//   rank 0 to helpers    done: all rocks before this one are done, on all ranks
//   rank 0 to helpers    gather: nothing is under way any more; what all summed up is added, along a tree of the ranks
//   rank to rank         ask: send me your sums, and those that you were sent
//   rank to rank         sums, in pieces, of which the last says so
//   rank 0 to helpers    stop: leave the rocks on their way
//   helper to rank 0     stopped: no more blocks will come
//   rank 0 to helpers    leave: with this exit code, whatever is under way
//
// and, at any time, from a helper: stop (it was asked to by a signal), cannot (something is wrong there).
//
// What a stopped run keeps are the rocks before the first one that was left, wherever that was. So nothing of a block
// is in the sums while one before it is under way.

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "talus/archive/run_description.hpp"
#include "talus/campaign/block_worker.hpp"
#include "talus/campaign/ranks.hpp"

namespace talus::project {

enum class MessageKind : std::uint8_t {
  hello,
  rocks,
  block,
  done,
  gather,
  ask_for_sums,
  piece_of_sums,
  end_of_sums,
  leave,
  stop,
  stopped,
  cannot
};

/// Its kind and what it says. Throws BadBytes where it is no message.
[[nodiscard]] MessageKind kind_of(const Ranks::Message& message);
[[nodiscard]] std::string_view content_of(const Ranks::Message& message);
[[nodiscard]] std::string message_of(MessageKind kind, std::string_view content = {});

struct Hello {
  std::string version;  // of the program
  std::string machine;
  int threads = 1;
  RunDescription description;
};
[[nodiscard]] std::string message_of(const Hello& hello);
/// Of another version only the version and the machine are read.
[[nodiscard]] Hello hello_from(std::string_view content);

[[nodiscard]] std::string message_of(const RockRange& rocks);
[[nodiscard]] RockRange rocks_from(std::string_view content);

/// Without what it adds to the sums.
[[nodiscard]] std::string message_of(const DoneBlock& block);
[[nodiscard]] DoneBlock block_from(std::string_view content);

/// That all rocks before this one are done.
[[nodiscard]] std::string done_message(std::uint64_t next_rock);
[[nodiscard]] std::uint64_t next_rock_from(std::string_view content);

/// What is wrong on a rank, and the exit code that it stands for.
struct Cannot {
  std::string machine, text;
  int exit_code = 0;
};
[[nodiscard]] std::string message_of(const Cannot& cannot);
[[nodiscard]] Cannot cannot_from(std::string_view content);

[[nodiscard]] std::string leave_message(int exit_code);
[[nodiscard]] int exit_code_from(std::string_view content);

/// How long a rank that found nothing to do sleeps before it looks for messages again: the longer nothing came the
/// longer, so that an answer is late by no more than it took to come. To sleep and wake costs about 15 us of a core;
/// waiting within MPI would take all of it.
class Naps {
 public:
  void found_something() { next_ = shortest; }
  /// While something is on its way it is short: it moves only when this rank looks.
  [[nodiscard]] std::chrono::microseconds next(Ranks& ranks);

 private:
  static constexpr std::chrono::microseconds shortest{30}, longest{2000};
  std::chrono::microseconds next_ = shortest;
};

/// What the ranks send each other while they add up; it may come before a rank has begun to.
class GatherInbox {
 public:
  /// Whether the message belongs here; keeps it if so.
  bool add(const Ranks::Message& message);

 private:
  friend void gather_sums(Ranks& ranks, GatherInbox& inbox, std::span<SummingObserver* const> observers,
                          const std::function<void(const Ranks::Message&)>& handle_other);

  bool is_asked_ = false;
  std::string sums_;  // of the one rank that was asked
  bool are_whole_ = false;
};

/// Adds up what the observers of all ranks hold, called by each of them: rank 0 has all of it afterwards, and the
/// others are to forget theirs. Along a tree, in as many rounds as the number of ranks has binary digits. Each rank
/// holds one other's sums at a time. Messages of other kinds are handed on; what handling them throws ends it.
void gather_sums(Ranks& ranks, GatherInbox& inbox, std::span<SummingObserver* const> observers,
                 const std::function<void(const Ranks::Message&)>& handle_other);

}  // namespace talus::project
