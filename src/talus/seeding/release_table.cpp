#include "talus/seeding/release_table.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <span>

#include "talus/seeding/hilbert_curve.hpp"

namespace talus {

namespace {

constexpr std::array number_members{&ReleaseRow::above_surface, &ReleaseRow::mass,  &ReleaseRow::volume,
                                    &ReleaseRow::density,       &ReleaseRow::speed, &ReleaseRow::horizontal,
                                    &ReleaseRow::vertical,      &ReleaseRow::spin};
constexpr std::array vector_members{&ReleaseRow::velocity, &ReleaseRow::spin_vector, &ReleaseRow::direction,
                                    &ReleaseRow::axes};

/// Appends the value of row `count`; a column begins with the first value that is given.
template <class Value>
void append(std::vector<Value>& column, const Value& value, std::size_t count) {
  if (column.empty() && !ReleaseRow::has(value)) return;
  if (column.empty()) column.resize(count, value * ReleaseRow::none);
  column.push_back(value);
}

}  // namespace

void ReleaseTable::add(const Vec3& place, const ReleaseRow& given, SourceId source, std::uint32_t number) {
  const std::size_t row = places_.size();
  for (std::size_t k = 0; k < number_members.size(); ++k) append(numbers_given_[k], given.*number_members[k], row);
  for (std::size_t k = 0; k < vector_members.size(); ++k) append(vectors_given_[k], given.*vector_members[k], row);
  if (sources_.empty() || sources_.back().source != source)
    sources_.push_back({static_cast<std::uint32_t>(row), source});
  places_.push_back(place);
  numbers_.push_back(number);
}

ReleaseRow ReleaseTable::given(std::size_t row) const {
  ReleaseRow given;
  for (std::size_t k = 0; k < number_members.size(); ++k)
    if (!numbers_given_[k].empty()) given.*number_members[k] = numbers_given_[k][row];
  for (std::size_t k = 0; k < vector_members.size(); ++k)
    if (!vectors_given_[k].empty()) given.*vector_members[k] = vectors_given_[k][row];
  return given;
}

SourceId ReleaseTable::source_of(std::size_t row) const {
  const auto after = std::upper_bound(sources_.begin(), sources_.end(), row,
                                      [](std::size_t at, const Run& run) { return at < run.first; });
  return std::prev(after)->source;
}

void ReleaseTable::order_by_place() {
  Vec2 low = Vec2::all(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& place : places_) {
    low = low.min(place.xy());
    high = high.max(place.xy());
  }
  const double side = places_.empty() ? 0 : (high - low).largest();
  const auto grid_place = [&](double away) {
    constexpr double cells = 4294967295.0;  // of the curve, along a side
    return static_cast<std::uint32_t>(side > 0 ? std::min(away / side, 1.0) * cells : 0.0);
  };
  std::vector<std::uint64_t> along;
  along.reserve(count());
  for (const Vec3& place : places_)
    along.push_back(along_hilbert_curve(grid_place(place.x() - low.x()), grid_place(place.y() - low.y())));
  by_place_.resize(count());
  std::iota(by_place_.begin(), by_place_.end(), 0U);
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const std::size_t end = k + 1 < sources_.size() ? sources_[k + 1].first : count();
    std::ranges::stable_sort(std::span(by_place_).subspan(sources_[k].first, end - sources_[k].first), {},
                             [&](std::uint32_t row) { return along[row]; });
  }
}

std::size_t ReleaseTable::bytes() const {
  std::size_t bytes = (numbers_.size() + by_place_.size()) * sizeof(std::uint32_t) + sources_.size() * sizeof(Run);
  visit_columns([&](const auto& column) { bytes += column.size() * sizeof(column[0]); });
  for (const std::string& name : names) bytes += sizeof(std::string) + name.capacity();
  return bytes;
}

}  // namespace talus
