#include "talus/results/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>
#include <unordered_map>

#include "talus/rocks/energy.hpp"

namespace talus {

Runout runout(const RockOutcome& outcome, const RunoutFrame& frame) {
  const Vec3& start = outcome.start.position;
  const Vec3& end = outcome.end.position;
  const Vec3 d = end - start;
  const RunoutPlace place = frame.of(start.xy(), end.xy());
  return {place.runout, -d.z(), d.norm(), place.lateral};
}

std::optional<Histogram> Tally::histogram(std::uint64_t bins) const {
  const auto values = sketch_.ascending();
  if (values.empty()) return std::nullopt;
  Histogram histogram(nice_bins(values.front().value, values.back().value, bins));
  for (const auto& [value, count] : values) histogram.add(value, count);
  return histogram;
}

void Tally::merge(const Tally& other) {
  for (const double x : other.first_) add_moments(x);
  if (!other.moments_.empty()) moments_of_first().merge(other.moments_.front());
  sketch_.merge(other.sketch_);
}

Moments& Tally::moments_of_first() {
  if (moments_.empty()) {
    moments_.push_back(moments());
    first_ = {};
  }
  return moments_.front();
}

Moments Tally::moments() const {
  if (!moments_.empty()) return moments_.front();
  Moments moments;
  for (const double x : first_) moments.add(x);
  return moments;
}

void Tally::save(ByteWriter& out) const {
  moments().save(out);
  sketch_.save(out);
}

void Tally::merge_saved(ByteReader& in) {
  Moments saved;
  saved.merge_saved(in);
  const std::uint64_t before = sketch_.count();
  sketch_.merge_saved(in);
  expect_bytes(saved.count() == sketch_.count() - before, "a quantity's counts disagree");
  if (saved.count() > 0) moments_of_first().merge(saved);
}

namespace {

template <class T>
void save_optional(ByteWriter& out, const std::optional<T>& value) {
  out.flag(value.has_value());
  if (value) out.put(*value);
}

/// The minimum of the present and the saved value.
template <class T>
void merge_least(ByteReader& in, std::optional<T>& value) {
  if (!in.flag()) return;
  const T saved = in.get<T>();
  if constexpr (std::is_floating_point_v<T>) expect_bytes(std::isfinite(saved), "a minimum is damaged");
  value = std::min(value.value_or(saved), saved);
}

template <std::size_t n>
void merge_counts(ByteReader& in, std::array<std::uint64_t, n>& counts) {
  for (std::uint64_t& count : counts) count += in.get<std::uint64_t>();
}

}  // namespace

void BarrierTally::merge(const BarrierTally& other) {
  translational_energy.merge(other.translational_energy);
  total_energy.merge(other.total_energy);
  height.merge(other.height);
  velocity.merge(other.velocity);
  for (std::size_t k = 0; k < outcomes.size(); ++k) outcomes[k] += other.outcomes[k];
  rocks_hit += other.rocks_hit;
  rocks_passed_above += other.rocks_passed_above;
  if (other.least_clearance)
    least_clearance = std::min(least_clearance.value_or(*other.least_clearance), *other.least_clearance);
}

void BarrierTally::save(ByteWriter& out) const {
  for (const Tally* tally : {&translational_energy, &total_energy, &height, &velocity}) tally->save(out);
  out.numbers(std::span(outcomes));
  out.put(rocks_hit);
  out.put(rocks_passed_above);
  save_optional(out, least_clearance);
}

void BarrierTally::merge_saved(ByteReader& in) {
  for (Tally* tally : {&translational_energy, &total_energy, &height, &velocity}) tally->merge_saved(in);
  merge_counts(in, outcomes);
  rocks_hit += in.get<std::uint64_t>();
  rocks_passed_above += in.get<std::uint64_t>();
  merge_least(in, least_clearance);
}

Summary::Summary(std::uint64_t planned_rocks, std::size_t barrier_count, const Vec3& origin)
    : planned(planned_rocks),
      end_x(planned_rocks, origin.x()),
      runout_plan(planned_rocks),
      runout_total(planned_rocks),
      max_kinetic_energy(planned_rocks),
      max_bounce(planned_rocks),
      barriers(barrier_count, BarrierTally(planned_rocks)) {}

void Summary::merge(const Summary& other) {
  done += other.done;
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k] += other.ends[k];
  lifted += other.lifted;
  if (other.first_lost) first_lost = std::min(first_lost.value_or(*other.first_lost), *other.first_lost);
  events += other.events;
  end_x.merge(other.end_x);
  runout_plan.merge(other.runout_plan);
  runout_total.merge(other.runout_total);
  max_kinetic_energy.merge(other.max_kinetic_energy);
  max_bounce.merge(other.max_bounce);
  flown.merge(other.flown);
  on_ground.merge(other.on_ground);
  for (std::size_t k = 0; k < other.barriers.size(); ++k) barriers[k].merge(other.barriers[k]);
}

void Summary::save(ByteWriter& out) const {
  out.put(planned);
  out.put(end_x.sketch().origin());
  out.put(done);
  out.numbers(std::span(ends));
  out.put(lifted);
  save_optional(out, first_lost);
  out.put(events);
  for (const Tally* tally : {&end_x, &runout_plan, &runout_total, &max_kinetic_energy, &max_bounce}) tally->save(out);
  flown.save(out);
  on_ground.save(out);
  out.count(barriers.size());
  for (const BarrierTally& barrier : barriers) barrier.save(out);
}

void Summary::merge_saved(ByteReader& in) {
  expect_bytes(in.get<std::uint64_t>() == planned, "the summary is of a run of another number of rocks");
  expect_bytes(in.get<double>() == end_x.sketch().origin(), "the summary's positions have another origin");
  done += in.get<std::uint64_t>();
  merge_counts(in, ends);
  lifted += in.get<std::uint64_t>();
  merge_least(in, first_lost);
  const auto saved_events = in.get<std::int64_t>();
  expect_bytes(saved_events >= 0 && saved_events <= std::numeric_limits<std::int64_t>::max() - events,
               "the number of events is damaged");
  events += saved_events;
  for (Tally* tally : {&end_x, &runout_plan, &runout_total, &max_kinetic_energy, &max_bounce}) tally->merge_saved(in);
  flown.merge_saved(in);
  on_ground.merge_saved(in);
  expect_bytes(
      done <= planned && end_x.count() == done && std::accumulate(ends.begin(), ends.end(), std::uint64_t{0}) == done,
      "the summary's counts disagree");
  expect_bytes(in.get<std::uint64_t>() == barriers.size(), "the summary has other barriers");
  for (BarrierTally& barrier : barriers) barrier.merge_saved(in);
}

std::vector<std::string> notes_of(const Summary& summary) {
  const std::uint64_t left = summary.ended(EndReason::left_model);
  if (!summary.are_many(left)) return {};
  return {fmt::format("{} of {} rocks left the model: runout, reach and end points are cut at its edge", left,
                      summary.done)};
}

namespace {

class SummaryPart : public ObserverPart {
 public:
  /// The runout frame must outlive the part.
  SummaryPart(std::uint64_t planned, const LocalFrame& frame, const RunoutFrame& runout_frame)
      : summary(planned, 0, frame.origin), frame_(frame), runout_frame_(runout_frame) {}

  void see(const RockRecord& record, const RockLog& log) override {
    const RockOutcome& outcome = record.outcome;
    ++summary.done;
    ++summary.ends[static_cast<std::size_t>(outcome.reason)];
    summary.lifted += record.was_lifted ? 1 : 0;
    if (outcome.reason == EndReason::lost && !summary.first_lost) summary.first_lost = record.rock;
    summary.events += outcome.events;
    const Runout way = runout(outcome, runout_frame_);
    summary.end_x.add(frame_.global_from_local(outcome.end.position).x());
    summary.runout_plan.add(way.plan);
    summary.runout_total.add(way.total);
    summary.max_kinetic_energy.add(outcome.max_kinetic_energy);
    summary.max_bounce.add(outcome.max_bounce);
    summary.flown.add(log.ways.flown);
    summary.on_ground.add(log.ways.on_ground);
    see_barriers(record, log);
  }

  Summary summary;                                           // without barriers
  std::unordered_map<std::uint32_t, BarrierTally> barriers;  // those that a rock hit or passed above

 private:
  void see_barriers(const RockRecord& record, const RockLog& log) {
    reached_.clear();
    for (const Passage& hit : log.hits) {
      BarrierTally& tally = tally_of(hit.barrier);
      const double speed = hit.motion.velocity.norm();
      const double translational = 0.5 * record.body.mass * speed * speed;
      tally.translational_energy.add(translational);
      tally.total_energy.add(translational + rotational_energy(record.body, hit.motion));
      tally.height.add(hit.height);
      tally.velocity.add(speed);
      ++tally.outcomes[static_cast<std::size_t>(hit.outcome)];
      reached_.push_back(hit.barrier.index);
    }
    for (const std::uint32_t barrier : take_reached()) ++tally_of({barrier}).rocks_hit;
    for (const Passage& passed : log.passed_above) {
      BarrierTally& tally = tally_of(passed.barrier);
      tally.least_clearance = std::min(tally.least_clearance.value_or(passed.clearance), passed.clearance);
      reached_.push_back(passed.barrier.index);
    }
    for (const std::uint32_t barrier : take_reached()) ++tally_of({barrier}).rocks_passed_above;
  }
  BarrierTally& tally_of(BarrierId barrier) {
    return barriers.try_emplace(barrier.index, summary.planned).first->second;
  }
  /// Each barrier in reached_ once, in ascending order; clears the list.
  std::span<const std::uint32_t> take_reached() {
    std::ranges::sort(reached_);
    unique_.clear();
    std::ranges::unique_copy(reached_, std::back_inserter(unique_));
    reached_.clear();
    return unique_;
  }

  LocalFrame frame_;
  const RunoutFrame& runout_frame_;
  std::vector<std::uint32_t> reached_, unique_;
};

}  // namespace

std::unique_ptr<ObserverPart> SummaryObserver::new_part() const {
  return std::make_unique<SummaryPart>(summary_.planned, frame_, runout_frame_);
}

void SummaryObserver::commit(ObserverPart& part) {
  const auto& seen = static_cast<SummaryPart&>(part);
  summary_.merge(seen.summary);
  for (const auto& [barrier, tally] : seen.barriers) summary_.barriers[barrier].merge(tally);
}

}  // namespace talus
