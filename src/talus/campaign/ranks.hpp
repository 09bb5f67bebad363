#pragma once
// Processes that simulate the rocks of one campaign together: `mpirun -n 8 talus run ...`. Here they are numbers that
// send each other bytes; the messages are in run/rank_messages.hpp.

#include <memory>
#include <optional>
#include <string>

namespace talus {

/// This process among the others. To be used only by the thread that joined.
class Ranks {
 public:
  struct Message {
    int from = 0;
    std::string bytes;
  };

  /// Waits until all ranks are at this point. Messages that are still in transit are received and discarded.
  virtual ~Ranks() = default;
  /// From 0 to size() - 1.
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// The machine that this rank runs on.
  [[nodiscard]] virtual std::string machine() const = 0;
  /// The cores that this rank may use, shared evenly with the other ranks on the same machine.
  [[nodiscard]] virtual int threads() const = 0;

  /// Does not wait. Messages from one rank to another arrive in the order in which they were sent.
  virtual void send(int to, std::string bytes) = 0;
  /// A message that has arrived, from any rank; nullopt if there is none. Does not wait.
  [[nodiscard]] virtual std::optional<Message> receive() = 0;
  /// Bytes passed to send() that have not left yet: they move on during calls of send(), receive() and this function.
  [[nodiscard]] virtual std::size_t unsent() = 0;
};

/// What the launcher of this process (mpirun, srun and the like) has set in the environment.
struct Launch {
  int rank = 0;
  std::optional<int> size;  // not given by all launchers
};
/// nullopt: started without a launcher.
[[nodiscard]] std::optional<Launch> find_launch();

/// Joins the other processes of the launcher; null if there are none. MPI is not initialized without a launcher, so
/// that a plain run is as fast and reliable as without MPI. Throws BadInput if others were started but cannot be
/// reached: each of them would simulate all rocks.
[[nodiscard]] std::unique_ptr<Ranks> join_ranks();

}  // namespace talus
