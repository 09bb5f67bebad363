#ifdef TALUS_HAS_GDAL

#include "talus/import/raster_band.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/import/filler_values.hpp"

namespace talus {

namespace {

constexpr float no_data = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Limits GDAL's block cache while a file is read once from end to end.
class BlockCacheLimit {
 public:
  explicit BlockCacheLimit(std::int64_t bytes) : before_(GDALGetCacheMax64()) { GDALSetCacheMax64(bytes); }
  BlockCacheLimit(const BlockCacheLimit&) = delete;
  BlockCacheLimit& operator=(const BlockCacheLimit&) = delete;
  ~BlockCacheLimit() { GDALSetCacheMax64(before_); }

 private:
  std::int64_t before_;
};

/// Reads a band and turns it north up.
class BandReader {
 public:
  BandReader(GDALRasterBand& band, const RasterPlacing& placing, GdalMessages& messages, RasterProblems& problems)
      : band_(band), placing_(placing), messages_(messages), problems_(problems) {}

  void into(RasterFile& out) {
    RasterGrid& grid = out.grid;
    grid.columns = static_cast<std::uint32_t>(band_.GetXSize());
    grid.rows = static_cast<std::uint32_t>(band_.GetYSize());
    grid.dx = placing_.dx;
    grid.dy = placing_.dy;
    grid.x0 = placing_.west + 0.5 * placing_.dx;
    grid.y0 = placing_.south + 0.5 * placing_.dy;
    const std::size_t nodes = static_cast<std::size_t>(grid.columns) * grid.rows;
    try {
      grid.z.resize(nodes);
      read_rows(grid);
    } catch (const std::bad_alloc&) {
      problems_.stop(
          fmt::format("has {} x {} cells", grid.columns, grid.rows),
          fmt::format("they need {:.1f} GB of memory", static_cast<double>(nodes) * sizeof(float) / 1e9),
          "Cut it to the slope: " + problems_.command("gdal_translate -projwin WEST NORTH EAST SOUTH", "_slope.tif"));
    }
    check_values(out);
  }

 private:
  void read_rows(RasterGrid& grid) {
    const int columns = band_.GetXSize();
    int block_columns = 0, block_rows = 0;
    band_.GetBlockSize(&block_columns, &block_rows);
    const std::int64_t bytes_of_row = std::int64_t{columns} * GDALGetDataTypeSizeBytes(band_.GetRasterDataType());
    // All blocks that contain the current rows stay cached while these are read, whatever the shape of the blocks.
    const BlockCacheLimit limit(std::max<std::int64_t>(std::int64_t{64} << 20, 2 * bytes_of_row * block_rows));
    const std::int64_t most_rows = std::max<std::int64_t>(1, (std::int64_t{32} << 20) / (8 * std::int64_t{columns}));
    const int at_once =
        static_cast<int>(std::min<std::int64_t>(block_rows * (1 + most_rows / (2 * block_rows)), most_rows));

    const bool has_mask = (band_.GetMaskFlags() & GMF_ALL_VALID) == 0;
    int has_scale = 0, has_offset = 0;
    const double scale = band_.GetScale(&has_scale), offset = band_.GetOffset(&has_offset);
    scale_ = has_scale ? scale : 1;
    offset_ = has_offset ? offset : 0;

    if (has_mask) mask_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(at_once));
    if (band_.GetRasterDataType() == GDT_Float32) {  // without a change of type it takes half the time
      read_rows_as<float>(grid, GDT_Float32, at_once);
    } else {
      read_rows_as<double>(grid, GDT_Float64, at_once);
    }
  }

  template <class Value>
  void read_rows_as(RasterGrid& grid, GDALDataType type, int at_once) {
    const int rows = band_.GetYSize();
    std::vector<Value> values(grid.columns * static_cast<std::size_t>(at_once));
    for (int first = 0; first < rows; first += at_once) {
      const int count = std::min(at_once, rows - first);
      fetch(band_, first, count, values.data(), type);
      if (!mask_.empty()) fetch(*band_.GetMaskBand(), first, count, mask_.data(), GDT_Byte);
      for (int k = 0; k < count; ++k) {
        const auto row = static_cast<std::uint32_t>(placing_.from_south ? first + k : rows - 1 - first - k);
        float* to = grid.z.data() + grid.index(0, row);
        const std::size_t from = static_cast<std::size_t>(k) * grid.columns;
        convert(std::span<const Value>(values).subspan(from, grid.columns),
                mask_.empty() ? nullptr : mask_.data() + from, to);
        if (placing_.from_east) std::reverse(to, to + grid.columns);
      }
    }
  }

  void fetch(GDALRasterBand& band, int first, int count, void* to, GDALDataType type) {
    stop_point();
    messages_.clear();
    const int columns = band.GetXSize();
    const CPLErr result = band.RasterIO(GF_Read, 0, first, columns, count, to, columns, count, type, 0, 0, nullptr);
    if (result == CE_None && !messages_.has_failure()) return;
    problems_.stop("cannot be read completely", messages_.failure(), "Copy it again from its source");
  }

  /// `mask`: 0 where there is no data; null without a mask.
  template <class Value>
  void convert(std::span<const Value> values, const std::uint8_t* mask, float* to) const {
    constexpr double largest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double z = double{values[i]} * scale_ + offset_;
      const bool has_data = std::abs(z) <= largest && (mask == nullptr || mask[i] != 0);
      to[i] = has_data ? static_cast<float>(z) : no_data;
    }
  }

  void check_values(RasterFile& out) {
    std::uint64_t impossible = 0;
    double farthest_from_0 = 0;
    Extremes extremes;
    for (const float z : out.grid.z) {
      if (std::isnan(z)) {
        ++out.without_data;
      } else if (z < lowest_elevation_m || z > highest_elevation_m) {
        ++impossible;
        if (std::abs(z) > std::abs(farthest_from_0)) farthest_from_0 = z;
      } else {
        extremes.add(z);
      }
    }
    if (impossible > 0) {
      problems_.stop(fmt::format("has elevations such as {:.10g} m", farthest_from_0),
                     fmt::format("{} of {} cells are below {:g} m or above {:g} m; they are probably no-data values "
                                 "that the file does not declare",
                                 impossible, out.grid.z.size(), lowest_elevation_m, highest_elevation_m),
                     declare(farthest_from_0));
    }
    check_fillers(out.grid, extremes);
    if (!has_surface(out.grid)) {
      problems_.stop("has no surface", out.without_data == out.grid.z.size()
                                           ? "no cell has data"
                                           : "a surface needs four neighbouring cells with data, and there are none");
    }
  }

  /// The two lowest and the two highest values.
  struct Extremes {
    float low = infinity, next_low = infinity, high = -infinity, next_high = -infinity;
    void add(float z) {
      if (z < low) next_low = std::exchange(low, z);
      if (z > low && z < next_low) next_low = z;
      if (z > high) next_high = std::exchange(high, z);
      if (z < high && z > next_high) next_high = z;
    }
  };

  /// The values that may mean no data, in their order: those that programs use, as such and as raw values, and an
  /// extreme far from all others.
  [[nodiscard]] std::vector<float> doubtful_values(const Extremes& extremes) const {
    std::vector<float> values{0.0F};
    for (const double filler : filler_values()) {
      for (const double z : {filler, filler * scale_ + offset_}) {
        if (z >= lowest_elevation_m && z <= highest_elevation_m) values.push_back(static_cast<float>(z));
      }
    }
    const auto is_far = [](float apart, float range) {
      constexpr float high_cliff_m = 300;
      return std::isfinite(apart) && apart > std::max(2 * range, high_cliff_m);
    };
    if (is_far(extremes.next_low - extremes.low, extremes.high - extremes.next_low)) values.push_back(extremes.low);
    if (is_far(extremes.high - extremes.next_high, extremes.next_high - extremes.low)) values.push_back(extremes.high);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

  /// Such values surrounded by walls are not ground but no-data values that the file does not declare. (The sea, or a
  /// local datum of 0, has gentle shores; a lake at 999 m lies within its shores. Where the whole terrain consists of
  /// walls, as with trees, walls mean nothing.)
  void check_fillers(const RasterGrid& grid, const Extremes& extremes) {
    constexpr double wall = 5;  // height over width
    constexpr double many = 0.1;
    struct Count {
      std::uint64_t cells = 0, borders = 0, walls = 0;
    };
    const std::vector<float> values = doubtful_values(extremes);
    const std::size_t other = values.size();
    std::vector<Count> counts(values.size() + 1);  // the last: of all other values
    const auto find_places = [&](std::uint32_t row, std::vector<std::size_t>& places) {
      const float* const z = grid.z.data() + grid.index(0, row);
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        const auto at = std::ranges::lower_bound(values, z[i]);
        places[i] = at != values.end() && *at == z[i] ? static_cast<std::size_t>(at - values.begin()) : other;
      }
    };
    const auto compare = [&](float a, float b, std::size_t of_a, std::size_t of_b, double apart) {
      if (std::isnan(a + b) || (of_a == of_b && of_a != other)) return;
      const std::uint64_t is_wall = std::abs(a - b) > wall * apart ? 1 : 0;
      const auto count = [&](std::size_t of, std::uint64_t sides) {
        counts[of].borders += sides;
        counts[of].walls += sides * is_wall;
      };
      if (of_a == of_b) return count(other, 2);
      if (of_a != other) count(of_a, 1);
      if (of_b != other) count(of_b, 1);
    };
    std::vector<std::size_t> here(grid.columns), north(grid.columns);  // places in `values`, of a row and the next
    find_places(0, here);
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      const bool has_next = row + 1 < grid.rows;
      if (has_next) find_places(row + 1, north);
      const float* const z = grid.z.data() + grid.index(0, row);
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        ++counts[here[i]].cells;
        if (i + 1 < grid.columns) compare(z[i], z[i + 1], here[i], here[i + 1], grid.dx);
        if (has_next) compare(z[i], z[i + grid.columns], here[i], north[i], grid.dy);
      }
      std::swap(here, north);
    }
    const Count& others = counts.back();
    const bool is_all_walls = static_cast<double>(others.walls) > many * static_cast<double>(others.borders);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto& [cells, borders, walls] = counts[k];
      if (2 * walls <= borders || is_all_walls) continue;
      problems_.warn(fmt::format("has {} cell{} of {:.10g} m", cells, cells == 1 ? "" : "s", values[k]),
                     fmt::format("walls surround {}; {} no-data value{} that the file does not declare",
                                 cells == 1 ? "it" : "them", cells == 1 ? "it is probably a" : "they are probably",
                                 cells == 1 ? "" : "s"),
                     declare(values[k]));
    }
  }

  [[nodiscard]] std::string declare(double z) const {
    return "Declare them: " +
           problems_.command(fmt::format("gdal_translate -a_nodata {:.17g}", raw(z)), "_declared.tif");
  }

  /// The value in the file, before scale and offset.
  [[nodiscard]] double raw(double z) const {
    if (scale_ == 1 && offset_ == 0) return z;
    constexpr double by_rounding = 1e-6;  // of scaled whole numbers
    const double value = (z - offset_) / scale_, whole = std::round(value);
    return std::abs(value - whole) <= by_rounding * std::abs(whole) ? whole : value;
  }

  static bool has_surface(const RasterGrid& grid) {
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
      const float *south = grid.z.data() + grid.index(0, row), *north = south + grid.columns;
      for (std::uint32_t i = 0; i + 1 < grid.columns; ++i) {
        if (!std::isnan(south[i] + south[i + 1] + north[i] + north[i + 1])) return true;
      }
    }
    return false;
  }

  GDALRasterBand& band_;
  const RasterPlacing& placing_;
  GdalMessages& messages_;
  RasterProblems& problems_;
  double scale_ = 1, offset_ = 0;
  std::vector<std::uint8_t> mask_;
};

}  // namespace

void read_band(GDALRasterBand& band, const RasterPlacing& placing, GdalMessages& messages, RasterProblems& problems,
               RasterFile& out) {
  BandReader(band, placing, messages, problems).into(out);
}

}  // namespace talus

#endif
