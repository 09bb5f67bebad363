#include "talus/seeding/release_table.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "talus/seeding/even_share.hpp"

namespace talus {

namespace {

constexpr std::array number_members{&ReleaseRow::above_surface, &ReleaseRow::mass,  &ReleaseRow::volume,
                                    &ReleaseRow::density,       &ReleaseRow::speed, &ReleaseRow::horizontal,
                                    &ReleaseRow::vertical,      &ReleaseRow::spin};
constexpr std::array vector_members{&ReleaseRow::velocity, &ReleaseRow::spin_vector, &ReleaseRow::direction};

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

std::size_t ReleaseTable::row_of(std::uint64_t k, std::uint64_t n) const { return place_of_share(k, n, count()); }

std::size_t ReleaseTable::bytes() const {
  std::size_t bytes = numbers_.size() * sizeof(std::uint32_t) + sources_.size() * sizeof(Run);
  visit_columns([&](const auto& column) { bytes += column.size() * sizeof(column[0]); });
  for (const std::string& name : names) bytes += sizeof(std::string) + name.capacity();
  return bytes;
}

}  // namespace talus
