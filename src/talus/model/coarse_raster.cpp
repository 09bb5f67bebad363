#include "talus/model/coarse_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace talus::project {

namespace {

// A patch: this many lines of a few to 128 nodes, along one of the axes. The traces of cells that were also turned by a
// few degrees still agree from line to line.
constexpr std::uint32_t lines_of_patch = 16, max_line_nodes = 128, min_line_nodes = 40;
constexpr std::uint32_t most_patches = 32;
constexpr double largest_ratio = 16.5;
// Traces of symmetric positions vanish in differences of odd or of even order, those of splines in low orders.
constexpr std::array orders = {1, 2, 3, 4};
constexpr std::uint32_t widest_difference = 4;  // nodes

using Line = std::array<double, max_line_nodes>;

bool is_multiple(double z, double step) {
  constexpr double by_rounding = 1e-7;  // of single precision, as a share of the elevation
  return std::abs(z - step * std::round(z / step)) <= by_rounding * std::abs(z);
}

/// 0.01 or 0.001 m if a sample of the elevations are multiples of it, otherwise 0.
double decimals_of(const RasterGrid& grid) {
  constexpr std::size_t sample = 1000;
  const std::size_t stride = 1 + grid.z.size() / sample;
  double unit = 0.01;
  for (std::size_t k = 0; k < grid.z.size(); k += stride) {
    const auto z = static_cast<double>(grid.z[k]);
    while (std::isfinite(z) && !is_multiple(z, unit)) {
      unit /= 10;
      if (unit < 0.0005) return 0;
    }
  }
  return unit;
}

/// How strongly the size of differences varies with each frequency.
struct Spectrum {
  std::vector<double> power;  // by frequency, the sum over patches
  int patches = 0;
};

class Patches {
 public:
  /// `decimals`: the unit to which elevations are rounded, 0 for that of single precision.
  Patches(const RasterGrid& grid, bool along_x, std::uint32_t length, double decimals)
      : grid_(grid), along_x_(along_x), length_(length), decimals_(decimals) {
    // Half a period of the line apart, from the largest ratio to two cells.
    for (double waves = length / largest_ratio; waves <= 0.5 * length; waves += 0.5)
      frequencies_.push_back(waves / length);
    for (std::uint32_t i = 0; i < length; ++i) {
      const double window = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (i + 0.5) / length);  // Hann
      for (const double f : frequencies_) cosines_.push_back(window * std::cos(2 * std::numbers::pi * f * i));
      for (const double f : frequencies_) sines_.push_back(window * std::sin(2 * std::numbers::pi * f * i));
    }
  }

  [[nodiscard]] const std::vector<double>& frequencies() const { return frequencies_; }

  [[nodiscard]] std::array<Spectrum, orders.size()> spectra() const {
    std::array<Spectrum, orders.size()> all;
    for (Spectrum& each : all) each.power.assign(frequencies_.size(), 0);
    const std::uint32_t along = along_x_ ? grid_.columns : grid_.rows, across = along_x_ ? grid_.rows : grid_.columns;
    const std::uint32_t abreast = std::max(1U, across / lines_of_patch);
    const std::uint32_t count = abreast * std::max(1U, (along - widest_difference) / length_);
    const std::uint32_t looked_at = std::min(count, most_patches);
    for (std::uint32_t k = 0; k < looked_at; ++k) {
      const auto patch = static_cast<std::uint32_t>(std::uint64_t{count} * k / looked_at);
      for (std::size_t order = 0; order < orders.size(); ++order) {
        add(all[order], patch / abreast * length_, patch % abreast * lines_of_patch, std::min(across, lines_of_patch),
            orders[order]);
      }
    }
    return all;
  }

 private:
  [[nodiscard]] double z(std::uint32_t along, std::uint32_t across) const {
    return static_cast<double>(grid_.z[along_x_ ? grid_.index(along, across) : grid_.index(across, along)]);
  }

  /// Sizes of the differences along a line, NaN where a node has no data.
  void fill(Line& sizes, std::uint32_t first, std::uint32_t across, int order) const {
    std::array<double, max_line_nodes + widest_difference> differences;
    for (std::uint32_t i = 0; i < length_ + widest_difference; ++i) differences[i] = z(first + i, across);
    for (int k = 0; k < order; ++k) {
      for (std::uint32_t i = 0; i + 1 < length_ + widest_difference; ++i)
        differences[i] = differences[i + 1] - differences[i];
    }
    for (std::uint32_t i = 0; i < length_; ++i) sizes[i] = std::abs(differences[i]);
  }

  /// Whether differences are no more than what rounding of the elevations makes.
  [[nodiscard]] bool is_rounding(const Line& sizes, std::uint32_t first, std::uint32_t across, int order) const {
    constexpr std::array gains = {2.0, 6.0, 20.0, 70.0};  // of variance, by order
    double sum = 0, highest = 0;
    std::uint32_t known = 0;
    for (std::uint32_t i = 0; i < length_; ++i) {
      if (!std::isfinite(sizes[i])) continue;
      sum += sizes[i];
      ++known;
      highest = std::max(highest, std::abs(z(first + i, across)));
    }
    const double unit = std::max(decimals_, std::exp2(std::ceil(std::log2(highest)) - 24));
    return sum <= known * unit * std::sqrt(gains[static_cast<std::size_t>(order - 1)] / 12);
  }

  /// Divides each size by the mean of those within two of the largest periods, so that steep and gentle ground count
  /// alike; NaN where the ground has no differences.
  void normalize(Line& sizes) const {
    constexpr std::uint32_t reach = 16;
    std::array<double, max_line_nodes + 1> sums;
    std::array<std::uint32_t, max_line_nodes + 1> counts;
    sums[0] = 0;
    counts[0] = 0;
    for (std::uint32_t i = 0; i < length_; ++i) {
      const bool is_known = std::isfinite(sizes[i]);
      sums[i + 1] = sums[i] + (is_known ? sizes[i] : 0);
      counts[i + 1] = counts[i] + (is_known ? 1 : 0);
    }
    for (std::uint32_t i = 0; i < length_; ++i) {
      const std::uint32_t from = i < reach ? 0 : i - reach, to = std::min(length_, i + reach + 1);
      const double sum = sums[to] - sums[from];
      sizes[i] = sum > 0 ? sizes[i] * (counts[to] - counts[from]) / sum : std::nan("");
    }
  }

  void add(Spectrum& spectrum, std::uint32_t first, std::uint32_t first_across, std::uint32_t lines, int order) const {
    Line sums{}, sizes;
    std::array<std::uint32_t, max_line_nodes> counts{};
    for (std::uint32_t k = 0; k < lines; ++k) {
      fill(sizes, first, first_across + k, order);
      if (is_rounding(sizes, first, first_across + k, order)) continue;
      normalize(sizes);
      for (std::uint32_t i = 0; i < length_; ++i) {
        if (!std::isfinite(sizes[i])) continue;
        sums[i] += sizes[i];
        ++counts[i];
      }
    }
    constexpr std::uint32_t enough_lines = 4;
    double all = 0;
    std::uint32_t known = 0;
    for (std::uint32_t i = 0; i < length_; ++i) {
      if (counts[i] < enough_lines) continue;
      sums[i] /= counts[i];
      all += sums[i];
      ++known;
    }
    if (known < length_ / 2) return;
    for (std::uint32_t i = 0; i < length_; ++i) sums[i] = counts[i] < enough_lines ? 0 : sums[i] - all / known;
    ++spectrum.patches;
    const std::size_t count = frequencies_.size();
    std::vector<double> x(count), y(count);
    for (std::uint32_t i = 0; i < length_; ++i) {
      const double *const cosine = cosines_.data() + i * count, *const sine = sines_.data() + i * count;
      for (std::size_t f = 0; f < count; ++f) {
        x[f] += sums[i] * cosine[f];
        y[f] += sums[i] * sine[f];
      }
    }
    const double scale = 1 / (known * static_cast<double>(length_));
    for (std::size_t f = 0; f < count; ++f) spectrum.power[f] += scale * (x[f] * x[f] + y[f] * y[f]);
  }

  const RasterGrid& grid_;
  bool along_x_;
  std::uint32_t length_;
  double decimals_;
  std::vector<double> frequencies_;
  std::vector<double> cosines_, sines_;  // by node and frequency
};

/// A peak of a spectrum.
struct Peak {
  double height = 0;     // over the spectrum around it
  double amplitude = 0;  // of the size of differences at this frequency, over their mean
};

/// Whether differences are large at single nodes of a period. Over waves of the ground they grow and fall like |sin|,
/// whose second harmonic has 1/5 of the amplitude of the first.
bool is_sharp(const std::vector<double>& power, const std::vector<double>& frequencies, std::size_t f) {
  constexpr double least = 0.3, has_no_second = 0.26;
  if (frequencies[f] > has_no_second) return true;
  const auto second = std::ranges::lower_bound(frequencies, 2 * frequencies[f] - 1e-9) - frequencies.begin();
  return power[std::min(static_cast<std::size_t>(second), power.size() - 1)] > least * least * power[f];
}

/// The highest peak of all orders at each frequency.
std::vector<Peak> peaks_of(const Patches& patches) {
  const std::vector<double>& frequencies = patches.frequencies();
  const double apart = 2 * (frequencies[1] - frequencies[0]);  // between independent frequencies
  std::vector<Peak> peaks(frequencies.size());
  for (const Spectrum& spectrum : patches.spectra()) {
    if (spectrum.patches == 0) continue;
    // The height of a peak by chance falls with the number of patches.
    const double certainty = 1 / (1 + 4.0 / spectrum.patches);
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
      std::vector<double> around;
      for (std::size_t k = 0; k < frequencies.size(); ++k) {
        const double ratio = frequencies[k] / frequencies[f], distance = std::abs(frequencies[k] - frequencies[f]);
        if (distance > 1.5 * apart && ((ratio > 0.6 && ratio < 1.7) || distance < 4 * apart))
          around.push_back(spectrum.power[k]);
      }
      const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
      std::ranges::nth_element(around, middle);
      if (!(*middle > 0)) continue;
      const Peak peak{certainty * spectrum.power[f] / *middle, 4 * std::sqrt(spectrum.power[f] / spectrum.patches)};
      constexpr double least_amplitude = 0.12;
      if (peak.amplitude > least_amplitude && peak.height > peaks[f].height && is_sharp(spectrum.power, frequencies, f))
        peaks[f] = peak;
    }
  }
  return peaks;
}

/// The lowest frequency at which the amplitude is nearly the largest: that of short traces is nearly the same at their
/// multiples.
template <class Amplitude>
std::size_t fundamental(std::size_t count, Amplitude&& amplitude) {
  double largest = 0;
  for (std::size_t f = 0; f < count; ++f) largest = std::max(largest, amplitude(f));
  std::size_t first = 0;
  while (amplitude(first) < 0.75 * largest) ++first;
  // Up to the top of its peak.
  while (first + 1 < count && amplitude(first + 1) > amplitude(first)) ++first;
  return first;
}

}  // namespace

std::optional<Vec2> interpolated_from(const RasterGrid& grid) {
  const std::uint32_t side = std::min(grid.columns, grid.rows);
  if (side < min_line_nodes + widest_difference) return std::nullopt;
  const std::uint32_t length = std::min(max_line_nodes, side - widest_difference);
  const double decimals = decimals_of(grid);
  const Patches rows(grid, true, length, decimals), columns(grid, false, length, decimals);
  const std::vector<Peak> on_x = peaks_of(rows), on_y = peaks_of(columns);
  const std::vector<double>& frequencies = rows.frequencies();

  // Different ratios, for example from degrees: the peaks must be high, and the variation strong.
  const auto alone = [](const std::vector<Peak>& peaks) {
    return [&peaks](std::size_t f) { return peaks[f].height < 20 ? 0 : peaks[f].amplitude; };
  };
  const std::size_t x = fundamental(frequencies.size(), alone(on_x)), y = fundamental(frequencies.size(), alone(on_y));
  const double weaker = std::min(alone(on_x)(x), alone(on_y)(y));
  // The same ratio on both axes: less is needed, for peaks by chance or of waves of the ground are not the same.
  const auto common = [&](std::size_t f) {
    return std::min(on_x[f].height, on_y[f].height) < 4.5 ? 0 : std::min(on_x[f].amplitude, on_y[f].amplitude);
  };
  const std::size_t both = fundamental(frequencies.size(), common);
  if (common(both) > 0.5 * weaker) return Vec2(grid.dx, grid.dy) / frequencies[both];
  if (weaker < 0.7) return std::nullopt;
  return Vec2(grid.dx / frequencies[x], grid.dy / frequencies[y]);
}

std::optional<double> elevation_step(const RasterGrid& grid) {
  constexpr std::array steps = {10.0, 5.0, 1.0, 0.5, 0.1};  // each a multiple of the next [m]
  const std::uint32_t stride = std::max<std::uint32_t>(1, grid.rows / 500);
  std::vector<double> bends;  // second differences along rows [m]
  std::size_t step = 0;
  for (std::uint32_t row = 0; row < grid.rows; row += stride) {
    const std::span<const float> z(grid.z.data() + grid.index(0, row), grid.columns);
    for (std::uint32_t column = 0; column + 2 < grid.columns; column += stride) {
      const double west = z[column], middle = z[column + 1], east = z[column + 2];
      const double bend = std::abs(east - 2 * middle + west);
      if (!std::isfinite(bend)) continue;
      bends.push_back(bend);
      while (!is_multiple(middle, steps[step])) {
        if (++step == steps.size()) return std::nullopt;
      }
    }
  }
  constexpr std::size_t few = 100;
  const double half = 0.5 * steps[step];
  const auto bent = std::ranges::count_if(bends, [&](double bend) { return bend > half; });
  const auto once = std::ranges::count_if(bends, [&](double bend) { return bend > half && bend < 3 * half; });
  const auto all = static_cast<std::ptrdiff_t>(bends.size());
  if (bends.size() < few || 10 * once < all || 2 * once < bent) return std::nullopt;
  return steps[step];
}

}  // namespace talus::project
