#include "talus/lines/line_follower.hpp"

namespace talus {

AskedBarriers::AskedBarriers(const Model& model, std::span<const AskedLine> lines) : all(model.barriers) {
  // A collector of the run stands for no one but itself.
  for (const AskedLine& line : lines) {
    numbers.push_back(line.of_model.value_or(static_cast<std::uint32_t>(all.size())));
    if (!line.of_model) all.push_back(line.barrier);
  }
  on_plan = index_of(all);
}

LineFollower::LineFollower(const Model& model, const AskedBarriers& barriers)
    : model_(model),
      asked_(barriers),
      section_(model.varying ? std::make_unique<OwnSection>(model, barriers.all) : nullptr),
      crossings_(section_ ? BarrierList(section_->barriers(), barriers.on_plan)
                          : BarrierList(barriers.all, barriers.on_plan)) {}

const RockLog& LineFollower::follow(const RockPath& path) {
  if (section_) section_->move_for(model_, path.record.rock);
  crossings_.begin(reach_of(model_.laws.model, path.record.body));
  for (const PathPiece& piece : path.pieces) {
    // With several lines, the last one is rarely known before the rock has ended.
    if (asked_.numbers.size() == 1 && crossings_.is_settled(BarrierId{asked_.numbers.front()}, piece.start_time)) break;
    crossings_.add(piece);
  }
  crossings_.end(path.record.outcome.reason == EndReason::stopped_by_barrier);
  return crossings_.found();
}

}  // namespace talus
