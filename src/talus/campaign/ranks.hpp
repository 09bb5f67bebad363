#pragma once
// Processes that throw the rocks of one campaign together: `mpirun -n 8 talus run ...`. Here they are no more than
// numbers that send each other bytes; what they say is run/rank_messages.hpp.

#include <memory>
#include <optional>
#include <string>

namespace talus {

/// This process among the others. All of it is for one thread: the one that joined.
class Ranks {
 public:
  struct Message {
    int from = 0;
    std::string bytes;
  };

  /// Waits until all ranks are at this point: what is still on its way is taken in and forgotten.
  virtual ~Ranks() = default;
  /// From 0 to size() - 1.
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// The machine that this rank runs on.
  [[nodiscard]] virtual std::string machine() const = 0;
  /// The cores that this rank may use, shared evenly with those on the same machine that may use them, too.
  [[nodiscard]] virtual int threads() const = 0;

  /// Does not wait. What one rank sends another comes in the order in which it was sent.
  virtual void send(int to, std::string bytes) = 0;
  /// A message that has come, from anybody; nothing if there is none. Does not wait.
  [[nodiscard]] virtual std::optional<Message> receive() = 0;
  /// Bytes that were sent and are still here: they move on while send(), receive() or this is called.
  [[nodiscard]] virtual std::size_t unsent() = 0;
};

/// What the environment says of the launcher (mpirun, srun and their like) that this process was started by.
struct Launch {
  int rank = 0;
  std::optional<int> size;  // not all say it
};
/// Nothing: it was started as a single program.
[[nodiscard]] std::optional<Launch> find_launch();

/// Joins the others that the launcher started. Null where there are none: nothing is asked of MPI unless a launcher is
/// there, so that a plain run is as quick and as sure as without MPI. Throws BadInput where others were started but
/// cannot be reached: each of them would throw all rocks.
[[nodiscard]] std::unique_ptr<Ranks> join_ranks();

}  // namespace talus
