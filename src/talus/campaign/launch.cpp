// Reads the environment variables that launchers set for the processes they start.

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
  const char* size;  // null: not given
};

// Open MPI's mpirun; the mpirun of MPICH and Intel, and srun --mpi=pmi2; srun --mpi=pmix, where Slurm gives the number
// of tasks. The last variable is also set by Open MPI, so it is looked up last.
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
