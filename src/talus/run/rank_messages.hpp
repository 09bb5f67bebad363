#pragma once
// The messages between the ranks of a run. Rank 0 hands out the rocks and writes the results; the others are its
// helpers:
//
//   helper to rank 0     hello: it has read the project; with a description of the run
//   rank 0 to helpers    rocks: a block to simulate; each helper has a few queued (campaign/block_counter.hpp)
//   helper to rank 0     block: the rows of its tables; its contribution to the sums is kept until
//   rank 0 to helpers    done: all rocks before this one are done, on all ranks
//   rank 0 to helpers    gather: no block is under way; the sums of all ranks are added up along a tree
//   rank to rank         ask: request the sums of a rank, including those it has received
//   rank to rank         sums, in pieces, followed by an end
//   rank 0 to helpers    stop: abandon the rocks under way
//   helper to rank 0     stopped: no more blocks will come
//   rank 0 to helpers    leave: exit with this code, whatever is under way
//
// and, at any time, from a helper: stop (requested by a signal), cannot (an error occurred there).
//
// A stopped run keeps the rocks before the first abandoned one, on whatever rank that was. So a block is added to the
// sums only when all earlier ones are done.

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

/// The kind and content of a message. Throws BadBytes if it is not a message.
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
/// From another version of Talus, only the version and the machine are read.
[[nodiscard]] Hello hello_from(std::string_view content);

[[nodiscard]] std::string message_of(const RockRange& rocks);
[[nodiscard]] RockRange rocks_from(std::string_view content);

/// Without its contribution to the sums.
[[nodiscard]] std::string message_of(const DoneBlock& block);
[[nodiscard]] DoneBlock block_from(std::string_view content);

/// All rocks before this one are done.
[[nodiscard]] std::string done_message(std::uint64_t next_rock);
[[nodiscard]] std::uint64_t next_rock_from(std::string_view content);

/// An error on a rank, and its exit code.
struct Cannot {
  std::string machine, text;
  int exit_code = 0;
};
[[nodiscard]] std::string message_of(const Cannot& cannot);
[[nodiscard]] Cannot cannot_from(std::string_view content);

[[nodiscard]] std::string leave_message(int exit_code);
[[nodiscard]] int exit_code_from(std::string_view content);

/// How long an idle rank sleeps before it polls for messages again. The naps double while nothing arrives, so that a
/// message is noticed late by no more than the time it took to arrive. Sleeping and waking costs about 15 us of a core;
/// waiting within MPI would occupy it.
class Naps {
 public:
  void found_something() { next_ = shortest; }
  /// Short while messages are being sent: they progress only when this rank polls.
  [[nodiscard]] std::chrono::microseconds next(Ranks& ranks);

 private:
  static constexpr std::chrono::microseconds shortest{30}, longest{2000};
  std::chrono::microseconds next_ = shortest;
};

/// Messages of gathering, which may arrive before a rank has begun to gather.
class GatherInbox {
 public:
  /// Whether the message belongs here; keeps it if so.
  bool add(const Ranks::Message& message);

 private:
  friend void gather_sums(Ranks& ranks, GatherInbox& inbox, std::span<SummingObserver* const> observers,
                          const std::function<void(const Ranks::Message&)>& handle_other);

  bool is_asked_ = false;
  std::string sums_;  // of the rank that was asked
  bool are_whole_ = false;
};

/// Adds up the sums of all ranks; must be called by each of them. Afterwards rank 0 has the total, and the others must
/// discard theirs. Proceeds along a binary tree, and a rank keeps the sums of one other rank at a time. Messages of
/// other kinds are passed to handle_other, whose exceptions end the gathering.
void gather_sums(Ranks& ranks, GatherInbox& inbox, std::span<SummingObserver* const> observers,
                 const std::function<void(const Ranks::Message&)>& handle_other);

}  // namespace talus::project
