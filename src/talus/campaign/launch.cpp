// Reads what launchers tell the processes that they start.

#include <charconv>
#include <cstdlib>
#include <cstring>

#include "talus/campaign/ranks.hpp"

namespace talus {

namespace {

std::optional<int> number_in_environment(const char* name) {
  const char* const text = name != nullptr ? std::getenv(name) : nullptr;
  if (text == nullptr) return std::nullopt;
  int value = 0;
  const char* const end = text + std::strlen(text);
  const auto [stopped, error] = std::from_chars(text, end, value);
  if (error != std::errc() || stopped != end || value < 0) return std::nullopt;
  return value;
}

struct Launcher {
  const char* rank;
  const char* size;  // null: it does not say
};

// Open MPI's mpirun; MPICH's and Intel's, and srun --mpi=pmi2; srun --mpi=pmix, whose number of tasks Slurm says; the
// last is also in the environment of Open MPI, which is why it comes last.
constexpr Launcher launchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, {"PMI_RANK", "PMI_SIZE"}, {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};

}  // namespace

std::optional<Launch> find_launch() {
  for (const Launcher& launcher : launchers) {
    if (const auto rank = number_in_environment(launcher.rank)) {
      return Launch{*rank, number_in_environment(launcher.size)};
    }
  }
  return std::nullopt;
}

}  // namespace talus
