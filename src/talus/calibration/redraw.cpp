#include "talus/calibration/redraw.hpp"

#include <algorithm>

#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;

constexpr auto rock_choice = static_cast<Stream>(1100), mark_choice = static_cast<Stream>(1102);

}  // namespace

Sample Sample::part(const std::vector<Index>& which) const {
  Sample part;
  part.rows.resize(static_cast<Index>(which.size()), rows.cols());
  for (std::size_t k = 0; k < which.size(); ++k) {
    part.rows.row(static_cast<Index>(k)) = rows.row(which[k]);
    if (!strata.empty()) part.strata.push_back(strata[static_cast<std::size_t>(which[k])]);
    if (!rocks.empty()) part.rocks.push_back(rocks[static_cast<std::size_t>(which[k])]);
  }
  return part;
}

Sample Sample::stratum(std::uint32_t number) const {
  if (strata.empty()) return number == 0 ? *this : part({});
  std::vector<Index> which;
  for (std::size_t row = 0; row < strata.size(); ++row) {
    if (strata[row] == number) which.push_back(static_cast<Index>(row));
  }
  return part(which);
}

std::vector<Index> Sample::first_rows() const {
  std::vector<Index> first;
  for (Index row = 0; row < rows.rows(); ++row) {
    const auto k = static_cast<std::size_t>(row);
    if (rocks.empty() || row == 0 || rocks[k] != rocks[k - 1]) first.push_back(row);
  }
  first.push_back(rows.rows());
  return first;
}

std::uint32_t Sample::stratum_count() const {
  return strata.empty() ? 1 : *std::max_element(strata.begin(), strata.end()) + 1;
}

Redraw::Redraw(const Sample& simulated, const Sample& like) : first_rows_(simulated.first_rows()) {
  const std::vector<Index> first = like.first_rows();
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    observed_.push_back(
        {like.has_strata() ? like.strata[static_cast<std::size_t>(first[k])] : 0, first[k + 1] - first[k]});
  }
  of_stratum_.resize(like.stratum_count());
  for (std::size_t k = 0; k + 1 < first_rows_.size(); ++k) {
    const std::uint32_t own =
        like.has_strata() ? simulated.strata[static_cast<std::size_t>(first_rows_[k])] : std::uint32_t{0};
    if (own < of_stratum_.size()) of_stratum_[own].push_back(k);
  }
}

bool Redraw::has_at_least(std::size_t rocks) const {
  return std::ranges::all_of(observed_,
                             [&](const ObservedRock& rock) { return of_stratum_[rock.stratum].size() >= rocks; });
}

void Redraw::rows(std::uint64_t seed, std::uint32_t replica, std::vector<Index>& rows) const {
  rows.clear();
  for (std::size_t k = 0; k < observed_.size(); ++k) {
    const auto item = static_cast<std::uint64_t>(replica) << 32U | k;
    const std::vector<std::size_t>& from = of_stratum_[observed_[k].stratum];
    const double choice = uniform_pair(seed, item, rock_choice, 0)[0];
    const std::size_t rock =
        from[std::min(static_cast<std::size_t>(choice * static_cast<double>(from.size())), from.size() - 1)];
    const Index first = first_rows_[rock], count = first_rows_[rock + 1] - first;
    if (count <= observed_[k].rows) {
      for (Index row = 0; row < count; ++row) rows.push_back(first + row);
      continue;
    }
    const auto key = philox(seed, item, static_cast<std::uint32_t>(mark_choice), 0);
    for (Index mark = 0; mark < observed_[k].rows; ++mark) {
      rows.push_back(first + static_cast<Index>(permuted(static_cast<std::uint64_t>(mark),
                                                         static_cast<std::uint64_t>(count), {key[0], key[1]})));
    }
  }
}

}  // namespace talus::calibration
