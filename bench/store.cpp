// The cost of storing trajectories: the same rocks without and with a store, in turn, and the bytes of a row.
// Usage: bench_store PROJECT [rocks] [threads] [repetitions]

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "common.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/store/store_observer.hpp"
#include "talus/store/trajectory_store.hpp"

using namespace talus;

namespace {

/// Asks for the pieces of paths, as maps do, which nearly every run makes.
class Pieces : public bench::EndHash {
 public:
  [[nodiscard]] bool wants_pieces() const override { return true; }
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print("Usage: bench_store PROJECT [rocks] [threads] [repetitions]\n");
    return 2;
  }
  project::Overrides overrides;
  overrides.rocks = argc > 2 ? std::atoll(argv[2]) : 100'000;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 1, repetitions = argc > 4 ? std::atoi(argv[4]) : 5;
  const project::Reading reading = project::read_project(argv[1], overrides);
  Problems warnings;
  const Model model = project::build_model(reading.project, warnings);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "talus-bench-store.bin";

  std::vector<double> bare, stored, writing, evaluating;
  StoreExtent extent;
  std::uint64_t hash = 0;
  for (int k = 0; k < repetitions; ++k) {
    Pieces ends;
    Observer* const without[] = {&ends};
    bare.push_back(bench::seconds([&] { (void)run_campaign(model, without, {threads, nullptr, {}}); }));
    hash = ends.hash();
    StoreObserver store(StoreBudget{.bytes = 256'000'000}, model);
    Pieces same;
    Observer* const with[] = {&same, &store};
    stored.push_back(bench::seconds([&] { (void)run_campaign(model, with, {threads, nullptr, {}}); }));
    writing.push_back(bench::seconds([&] { extent = store.write(file, model.rocks()); }));
    evaluating.push_back(bench::seconds([&] {
      const TrajectoryStore reader(file);
      StoredTrajectory trajectory;
      for (std::size_t place = 0; place < reader.rocks().size(); ++place) reader.read(place, trajectory);
    }));
  }
  std::filesystem::remove(file);
  const auto rocks = static_cast<double>(extent.rocks);
  fmt::print("{}: {} rocks, {} threads, {:.3f} s without a store, hash {:016x}\n", reading.project.name, model.rocks(),
             threads, median(bare), hash);
  fmt::print("  with a store: {:.3f} s, {:.2f} us more a rock, and {:.3f} s for the file\n", median(stored),
             (median(stored) - median(bare)) * threads * 1e6 / static_cast<double>(model.rocks()), median(writing));
  fmt::print("  {} rocks in {:.1f} MB: {:.1f} rows and {:.0f} bytes a rock, {:.1f} bytes a row (wanted: 40)\n",
             extent.rocks, static_cast<double>(extent.bytes) / 1e6, static_cast<double>(extent.rows) / rocks,
             static_cast<double>(extent.bytes) / rocks,
             static_cast<double>(extent.bytes) / static_cast<double>(extent.rows));
  fmt::print("  reading all: {:.3f} s\n", median(evaluating));
}
