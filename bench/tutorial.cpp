// Tutorial 1 with variation: rocks per second, on one thread and on all, statistics only, in section and extruded.
// Usage: bench_tutorial [rocks]

#include <tbb/info.h>

#include <cstdlib>
#include <filesystem>

#include "common.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/results/summary.hpp"

using namespace talus;

int main(int argc, char** argv) {
  const std::int64_t rocks = argc > 1 ? std::atoll(argv[1]) : 1'000'000;
  for (const char* file : {"tutorial-1-2d.toml", "tutorial-1-3d.toml"}) {
    const auto path = std::filesystem::path(TALUS_SOURCE_DIR) / "examples/tutorial-1" / file;
    project::Reading reading = project::read_project(path, {{}, rocks, {}});
    reading.project.barriers.clear();
    Problems warnings;
    const Model model = project::build_model(reading.project, warnings);
    for (const int threads : {1, tbb::info::default_concurrency()}) {
      bench::EndHash ends;
      SummaryObserver summary(model.rocks(), 0, model.frame);
      Observer* const observers[] = {&ends, &summary};
      const CampaignOutcome outcome = run_campaign(model, observers, {threads, nullptr, {}});
      fmt::print(
          "{}: {} rocks, {} threads, {:.2f} s, {:.0f} rocks/s, {:.0f} rocks/s per thread, {:.1f} events per rock, hash "
          "{:016x}\n",
          file, outcome.done, threads, outcome.seconds, static_cast<double>(outcome.done) / outcome.seconds,
          static_cast<double>(outcome.done) / outcome.seconds / threads,
          static_cast<double>(ends.events) / static_cast<double>(ends.rocks), ends.hash());
    }
  }
}
