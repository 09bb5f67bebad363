#pragma once
// The paths of all rocks of a project, in memory, and the design that its run makes.

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/projects.hpp"
#include "talus/archive/design_tables.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/lines/rock_paths.hpp"
#include "talus/model/design_plan.hpp"
#include "talus/results/design_result.hpp"

namespace talus::testing_tools {

class SimulatedPaths : public RockPaths {
 public:
  void add(const RockRecord& record, const RockLog& log) {
    RockPath& path = paths_.emplace_back();
    path.record = record;
    log.for_each_piece([&](const PathPiece& piece) { path.pieces.push_back(piece); });
    path.rows = log.rows;
    rocks_.push_back(record.rock);
    largest_radius_ = std::max(largest_radius_, record.body.radius);
  }
  /// As if of `simulated` rocks only these were kept.
  void keep(std::uint64_t simulated, const std::function<bool(std::uint64_t)>& keeps) {
    simulated_ = simulated;
    std::erase_if(paths_, [&](const RockPath& path) { return !keeps(path.record.rock); });
    std::erase_if(rocks_, [&](std::uint64_t rock) { return !keeps(rock); });
  }
  [[nodiscard]] std::uint64_t planned() const override { return simulated(); }
  [[nodiscard]] std::uint64_t simulated() const override { return std::max(simulated_, std::uint64_t{rocks_.size()}); }
  [[nodiscard]] std::span<const std::uint64_t> rocks() const override { return rocks_; }
  [[nodiscard]] double largest_radius() const override { return largest_radius_; }
  [[nodiscard]] std::vector<std::size_t> near(const PlanBounds&) const override { return all(); }
  [[nodiscard]] std::vector<std::size_t> near(std::span<const Vec2>, double) const override { return all(); }
  void read(std::size_t place, RockPath& into) const override { into = paths_[place]; }

 private:
  [[nodiscard]] std::vector<std::size_t> all() const {
    std::vector<std::size_t> places(rocks_.size());
    for (std::size_t k = 0; k < places.size(); ++k) places[k] = k;
    return places;
  }

  std::uint64_t simulated_ = 0;
  std::vector<RockPath> paths_;
  std::vector<std::uint64_t> rocks_;
  double largest_radius_ = 0;
};

/// A project that has been run, with its design if it has one.
struct SimulatedRun {
  project::Project project;
  Model model;
  SimulatedPaths paths;
  std::vector<RockRecord> records;
  std::vector<RockLog> logs;
  DesignPlan plan;
  DesignResult design;

  explicit SimulatedRun(const std::string& text) {
    Problems warnings;
    project = project::read_project_text(text, "slope.toml").project;
    model = project::build_model(project, warnings);
    if (project.design) plan = project::design_plan(project, model);
    DesignObserver observer(plan, model.rocks());
    const auto part = observer.new_part();
    Simulator simulator(model);
    for (std::uint64_t rock = 0; rock < model.rocks(); ++rock) {
      const RockRecord record = simulator.simulate(rock, true, true);
      records.push_back(record);
      logs.push_back(simulator.log());
      paths.add(record, simulator.log());
      part->see(record, simulator.log());
    }
    observer.commit(*part);
    design = evaluate(plan, observer.tally());
  }
};

}  // namespace talus::testing_tools
