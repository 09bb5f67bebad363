// The only file that uses MPI. A build without MPI refuses to run on several ranks.

#ifdef TALUS_HAS_MPI
#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <map>
#include <thread>
#include <vector>
#endif

#include <fmt/format.h>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/ranks.hpp"
#include "talus/core/problems.hpp"

namespace talus {

namespace {

[[noreturn]] void refuse(int processes, std::string why, std::string hint) {
  throw BadInput(Problem{.where = "mpirun",
                         .what = fmt::format("cannot share the rocks between {} processes", processes),
                         .why = std::move(why),
                         .hint = std::move(hint) + ", or run each process on its own (--alone)"});
}

}  // namespace

#ifdef TALUS_HAS_MPI

namespace {

// MPI counts bytes with an int: longer messages are sent in pieces, all but the last with tag_more.
constexpr int tag_last = 1, tag_more = 2;
constexpr std::size_t longest_piece = std::size_t{1} << 30;

/// The cores that this rank may use, each divided by the number of ranks on its machine that may use it.
int fair_share_of_cores() {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int neighbours = 1;
  MPI_Comm_size(machine, &neighbours);
  constexpr int most_cores = CPU_SETSIZE;  // with more cores the system call fails
  cpu_set_t cores;
  CPU_ZERO(&cores);
  const bool is_known = sched_getaffinity(0, sizeof cores, &cores) == 0;
  std::vector<int> mine(most_cores + 1, 0), users(most_cores + 1, 0);
  for (int k = 0; is_known && k < most_cores; ++k) mine[static_cast<std::size_t>(k)] = CPU_ISSET(k, &cores) ? 1 : 0;
  mine.back() = is_known ? 0 : 1;
  MPI_Allreduce(mine.data(), users.data(), most_cores + 1, MPI_INT, MPI_SUM, machine);
  MPI_Comm_free(&machine);
  if (users.back() > 0) return std::max(1, threads_for(0) / neighbours);
  double share = 0;
  for (std::size_t k = 0; k < most_cores; ++k) share += mine[k] > 0 ? 1.0 / users[k] : 0;
  return std::max(1, static_cast<int>(share + 1e-6));
}

class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    // Only this thread calls MPI.
    int level = MPI_THREAD_SINGLE;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    threads_ = fair_share_of_cores();
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;
  ~MpiRanks() override {
    // This rank has nothing more to exchange, but others may have sent it messages, and cannot end before they are
    // received. A wait inside MPI would keep a core busy.
    while (unsent() > 0) receive_or_sleep();
    MPI_Request all_ranks = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &all_ranks);
    for (int are_here = 0; are_here == 0;) {
      receive_or_sleep();
      MPI_Test(&all_ranks, &are_here, MPI_STATUS_IGNORE);
    }
    MPI_Finalize();
  }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  [[nodiscard]] int threads() const override { return threads_; }
  [[nodiscard]] std::string machine() const override {
    char name[MPI_MAX_PROCESSOR_NAME];
    int length = 0;
    MPI_Get_processor_name(name, &length);
    return {name, static_cast<std::size_t>(length)};
  }

  void send(int to, std::string bytes) override {
    std::size_t begin = 0;
    for (; bytes.size() - begin > longest_piece; begin += longest_piece) {
      send_piece(to, bytes.substr(begin, longest_piece), tag_more);
    }
    send_piece(to, begin == 0 ? std::move(bytes) : bytes.substr(begin), tag_last);
  }

  [[nodiscard]] std::optional<Message> receive() override {
    forget_sent();
    while (true) {
      int is_there = 0;
      MPI_Message handle = MPI_MESSAGE_NULL;
      MPI_Status status;
      MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &handle, &status);
      if (is_there == 0) return std::nullopt;
      int size = 0;
      MPI_Get_count(&status, MPI_BYTE, &size);
      std::string& bytes = unfinished_[status.MPI_SOURCE];
      const std::size_t before = bytes.size();
      bytes.resize(before + static_cast<std::size_t>(size));
      MPI_Mrecv(bytes.data() + before, size, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
      if (status.MPI_TAG == tag_more) continue;
      Message message{status.MPI_SOURCE, std::move(bytes)};
      unfinished_.erase(status.MPI_SOURCE);
      return message;
    }
  }

  [[nodiscard]] std::size_t unsent() override {
    forget_sent();
    return unsent_;
  }

 private:
  /// MPI reads the bytes until the request is complete; until then they must not move.
  struct Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void receive_or_sleep() {
    if (!receive()) std::this_thread::sleep_for(std::chrono::microseconds(100));
  }

  void send_piece(int to, std::string bytes, int tag) {
    Sending& sending = sending_.emplace_back(Sending{std::move(bytes)});
    unsent_ += sending.bytes.size();
    MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD,
              &sending.request);
  }

  void forget_sent() {
    for (auto each = sending_.begin(); each != sending_.end();) {
      int is_done = 0;
      MPI_Test(&each->request, &is_done, MPI_STATUS_IGNORE);
      if (is_done == 0) {
        ++each;
        continue;
      }
      unsent_ -= each->bytes.size();
      each = sending_.erase(each);
    }
  }

  int rank_ = 0, size_ = 1, threads_ = 1;
  std::list<Sending> sending_;
  std::size_t unsent_ = 0;
  std::map<int, std::string> unfinished_;  // by sender: the pieces of a message received so far
};

}  // namespace

std::unique_ptr<Ranks> join_ranks() {
  const std::optional<Launch> launch = find_launch();
  if (!launch || launch->size == 1) return nullptr;
  auto ranks = std::make_unique<MpiRanks>();
  if (launch->size && ranks->size() != *launch->size) {
    refuse(*launch->size, "this program's MPI does not recognize the launcher that started them",
           "Start them with the mpirun of that MPI, or with srun --mpi=pmix");
  }
  if (ranks->size() == 1) return nullptr;
  return ranks;
}

#else

std::unique_ptr<Ranks> join_ranks() {
  const std::optional<Launch> launch = find_launch();
  if (!launch || launch->size.value_or(1) == 1) return nullptr;
  refuse(*launch->size, "this program was built without MPI", "Build it with TALUS_MPI=ON");
}

#endif

}  // namespace talus
