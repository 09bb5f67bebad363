// The time of an answer about a line after a run, as while a line is dragged: at places between the mean release and
// the mean end of the rocks, across their way. Usage: bench_lines PROJECT [rocks] [places]

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include "common.hpp"
#include "talus/lines/asked_run.hpp"
#include "talus/lines/stored_paths.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/store/store_observer.hpp"

using namespace talus;

namespace {

/// Where rocks start and end on average, on plan, in the project's coordinates.
std::array<Vec2, 2> means_of(const Model& model, const RockPaths& paths) {
  std::array<Vec2, 2> sums{Vec2{}, Vec2{}};
  RockPath path;
  for (std::size_t place = 0; place < paths.rocks().size(); ++place) {
    paths.read(place, path);
    if (path.pieces.empty()) continue;
    sums[0] += model.frame.global_from_local(path.pieces.front().path.p).xy();
    sums[1] += model.frame.global_from_local(path.record.outcome.end.position).xy();
  }
  for (Vec2& sum : sums) sum /= static_cast<double>(paths.rocks().size());
  return sums;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print("Usage: bench_lines PROJECT [rocks] [places]\n");
    return 2;
  }
  project::Overrides overrides;
  if (argc > 2) overrides.rocks = std::atoll(argv[2]);
  const int places = argc > 3 ? std::max(1, std::atoi(argv[3])) : 20;
  const project::Reading reading = project::read_project(argv[1], overrides);
  Problems warnings;
  const Model model = project::build_model(reading.project, warnings);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "talus-bench-lines.bin";
  StoreObserver store(StoreBudget{.bytes = 256'000'000}, model);
  Observer* const observers[] = {&store};
  (void)run_campaign(model, observers, {0, nullptr, {}});
  const StoreExtent extent = store.write(file, model.rocks());

  std::unique_ptr<const AskedRun> asked;
  const double opening =
      bench::seconds([&] { asked = std::make_unique<const AskedRun>(model, std::make_unique<StoredPaths>(file)); });
  const auto [from, to] = means_of(model, asked->paths());
  const Vec2 way = to - from, across = Vec2(-way.y(), way.x()) * 0.75;
  std::vector<double> times;
  std::uint64_t hash = 0xcbf29ce484222325, crossings = 0;
  for (int k = 0; k < places; ++k) {
    const Vec2 middle = from + (0.2 + 0.6 * k / places) * way;
    const std::vector<PlanPlace> line{{middle.x() - across.x(), middle.y() - across.y()},
                                      {middle.x() + across.x(), middle.y() + across.y()}};
    RunAnswer answer;
    std::string text;
    times.push_back(1000 * bench::seconds([&] {
                      Problems cut;
                      const AskedLine drawn = drawn_line(model, line, asked_height, "line", cut);
                      project::DesignBasis basis = project::design_basis(reading.project);
                      add_kits_for_sliders(basis);
                      basis.design.section_m = usual_section(drawn.barrier);
                      answer = asked->line(basis, drawn, {});
                      text = answer.json.dump();
                    }));
    crossings += answer.rocks.size();
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  std::filesystem::remove(file);
  fmt::print("{}: {} rocks stored in {:.1f} MB, opened in {:.0f} ms\n", reading.project.name, extent.rocks,
             static_cast<double>(extent.bytes) / 1e6, 1000 * opening);
  const double first = times.front();
  std::ranges::sort(times);
  fmt::print(
      "  {} lines of {:.0f} m, {} crossings: first answer {:.1f} ms, median {:.1f} ms, slowest {:.1f} ms, hash "
      "{:016x}\n",
      places, 2 * across.norm(), crossings, first, times[times.size() / 2], times.back(), hash);
}
