#include "talus/import/raster_file.hpp"

#ifdef TALUS_HAS_GDAL

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <string_view>

#include "talus/core/memory.hpp"
#include "talus/core/stop.hpp"
#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus {

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// How the cells of a file stand on plan.
struct Placing {
  double west, south;          // outer corner [m]
  double dx, dy;               // of a cell, positive [m]
  bool from_east, from_south;  // the order in which the file has its columns and rows
};

/// Keeps GDAL's memory of blocks small while a file is read from one end to the other.
class BlockMemory {
 public:
  explicit BlockMemory(std::int64_t bytes) : before_(GDALGetCacheMax64()) { GDALSetCacheMax64(bytes); }
  BlockMemory(const BlockMemory&) = delete;
  BlockMemory& operator=(const BlockMemory&) = delete;
  ~BlockMemory() { GDALSetCacheMax64(before_); }

 private:
  std::int64_t before_;
};

std::optional<Placing> placing(GDALDataset& dataset, RasterProblems& problems) {
  double t[6];
  if (!read_geotransform(dataset, t, problems)) return std::nullopt;
  const double columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
  // Over the whole raster, a thousandth of a cell is rounding.
  if (std::abs(t[2]) * rows > 1e-3 * std::abs(t[1]) || std::abs(t[4]) * columns > 1e-3 * std::abs(t[5])) {
    problems.refuse("is turned or sheared against the map",
                    fmt::format("its geotransform is {:g}, {:g}, {:g}, {:g}, {:g}, {:g}; Talus needs rows from west to "
                                "east",
                                t[0], t[1], t[2], t[3], t[4], t[5]),
                    "Turn it: " + problems.command("gdalwarp -r bilinear", "_north_up.tif"));
    return std::nullopt;
  }
  Placing out{};
  out.dx = std::abs(t[1]);
  out.dy = std::abs(t[5]);
  out.from_east = t[1] < 0;
  out.from_south = t[5] > 0;
  out.west = out.from_east ? t[0] - columns * out.dx : t[0];
  out.south = out.from_south ? t[3] : t[3] - rows * out.dy;
  return out;
}

/// Of a file that names no coordinate system, numbers that can hardly be metres.
bool seems_to_be_in_degrees(GDALDataset& dataset, const Placing& at) {
  constexpr double widest = 10;          // degrees; a terrain of that size has no slopes to look at
  constexpr double largest_cell = 0.01;  // degrees, a kilometre; cells of a centimetre would be as strange
  const double east = at.west + at.dx * dataset.GetRasterXSize(), north = at.south + at.dy * dataset.GetRasterYSize();
  return at.west >= -180 && east <= 360 && at.south >= -90 && north <= 90 && east - at.west < widest &&
         north - at.south < widest && std::max(at.dx, at.dy) < largest_cell;
}

/// The file's own, or that which is said of files that name none.
std::optional<OGRSpatialReference> crs_of(GDALDataset& dataset, const ProjectCrs& said, GdalMessages& messages,
                                          RasterProblems& problems) {
  messages.clear();
  const OGRSpatialReference* own = dataset.GetSpatialRef();
  if (own == nullptr && messages.has_failure()) {
    problems.stop("has a coordinate system that cannot be read", messages.failure());
  }
  if (own && !own->IsEmpty()) {
    const SurveyCrs of_file{wkt_of(*own), name_of(*own)};
    if (said.is_local || (said.crs.is_known() && !have_same_plan(of_file, said.crs))) {
      problems.refuse(fmt::format("is in {}", of_file.name),
                      fmt::format("the project says crs = \"{}\"", said.is_local ? "local" : said.crs.name),
                      "Leave out crs, or give the file the true one: " +
                          problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif"));
    }
    return *own;
  }
  OGRSpatialReference crs;
  if (!said.crs.is_known() || crs.importFromWkt(said.crs.wkt.c_str()) != OGRERR_NONE) return std::nullopt;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

void judge_place(GDALDataset& dataset, const Placing& at, const OGRSpatialReference* crs, bool is_local,
                 RasterProblems& problems) {
  constexpr double smallest_cell = 1e-3;  // m
  const double east = at.west + at.dx * dataset.GetRasterXSize(), north = at.south + at.dy * dataset.GetRasterYSize();
  if (std::max({std::abs(at.west), std::abs(east), std::abs(at.south), std::abs(north)}) > largest_coordinate_m) {
    problems.refuse("lies too far away",
                    fmt::format("x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}; coordinates lie within {:g} m",
                                at.west, east, at.south, north, largest_coordinate_m),
                    "Tell it: " + problems.command("gdal_translate -a_ullr WEST NORTH EAST SOUTH", "_placed.tif"));
  } else if (crs ? !crs->IsGeographic() && std::min(at.dx, at.dy) < smallest_cell
                 : !is_local && seems_to_be_in_degrees(dataset, at)) {
    problems.refuse("seems to be in degrees",
                    fmt::format("its cells are {:.6g} x {:.6g}, and it {}", at.dx, at.dy,
                                crs ? "is said to be in " + name_of(*crs) : "names no coordinate system"),
                    "Name the true one: " + problems.command("gdal_translate -a_srs EPSG:4326", "_placed.tif") +
                        ", and project that");
  }
}

// Shares of the memory that there is: a terrain may take a half, since the maps of its rocks need some, too; of a tenth
// it is said before.
constexpr double share_of_memory = 0.5, much_memory = 0.1;

/// Cells take memory before the first of them is read, however short the file is.
void judge_memory(GDALDataset& dataset, RasterProblems& problems) {
  const double nodes = static_cast<double>(dataset.GetRasterXSize()) * dataset.GetRasterYSize();
  // The elevations, and a row or two in 64 bits.
  const double needed = nodes * sizeof(float) + 2.0 * sizeof(double) * dataset.GetRasterXSize();
  const auto there = static_cast<double>(usable_memory());
  const std::string cells = fmt::format("has {} x {} cells", dataset.GetRasterXSize(), dataset.GetRasterYSize());
  const std::string cut =
      "Cut it to the slope: " + problems.command("gdal_translate -projwin WEST NORTH EAST SOUTH", "_slope.tif");
  if (needed > share_of_memory * there) {
    problems.refuse(cells,
                    fmt::format("they need {:.1f} GB of memory; of the {:.1f} GB that there are half may be taken",
                                needed / 1e9, there / 1e9),
                    cut);
  } else if (needed > much_memory * there) {
    problems.warn(cells, fmt::format("they take {:.1f} GB of memory", needed / 1e9), cut);
  }
}

void judge_size(GDALDataset& dataset, RasterProblems& problems) {
  const std::int64_t columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
  if (columns < 2 || rows < 2) {
    problems.refuse(fmt::format("has {} x {} cells", columns, rows), "a surface needs 2 x 2 or more");
  }
  if (static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows) >= most_raster_nodes) {
    problems.refuse(
        fmt::format("has {} x {} cells", columns, rows), fmt::format("Talus takes fewer than {}", most_raster_nodes),
        "Cut it to the slope: " + problems.command("gdal_translate -projwin WEST NORTH EAST SOUTH", "_slope.tif"));
  } else {
    judge_memory(dataset, problems);
  }
}

/// A unit of height that a band or a coordinate system names; nothing for a name that nobody knows.
std::optional<double> metres_of_unit(std::string name) {
  for (char& c : name) c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  struct Known {
    double metres = 1;  // of one
    std::array<std::string_view, 6> names;
  };
  // The international foot and that of the US survey: NIST Special Publication 811, appendix B.
  static constexpr std::array<Known, 6> known{
      {{1, {"m", "metre", "metres", "meter", "meters", "mtr"}},
       {0.3048, {"ft", "foot", "feet", "international foot", "ft (intl)"}},
       {1200.0 / 3937, {"us survey foot", "us ft", "ftus", "foot us", "us foot"}},
       {0.1, {"dm", "decimetre", "decimeter", "decimetres", "decimeters"}},
       {0.01, {"cm", "centimetre", "centimeter", "centimetres", "centimeters"}},
       {0.001, {"mm", "millimetre", "millimeter", "millimetres", "millimeters"}}}};
  for (const Known& unit : known) {
    if (std::find(unit.names.begin(), unit.names.end(), name) != unit.names.end()) return unit.metres;
  }
  return std::nullopt;
}

void judge_unit(GDALRasterBand& band, const OGRSpatialReference* crs, RasterProblems& problems) {
  const std::string unit = band.GetUnitType() ? band.GetUnitType() : "";
  if (crs && has_depths(*crs)) {
    problems.refuse(
        "has depths", name_of(*crs) + " counts them downwards; Talus needs heights",
        "Turn them round: " +
            problems.command("gdal_translate -ot Float32 -scale 0 1 0 -1 -a_srs EPSG:XXXX", "_heights.tif"));
  }
  const auto refuse = [&](const std::string& name, std::optional<double> metres) {
    if (metres) {
      problems.refuse(fmt::format("has heights in {}", name),
                      fmt::format("Talus needs metres; one of these units is {:.10g} m", *metres),
                      "Convert them: " + command_to_metres_of_height(*metres, crs, problems));
    } else {
      problems.refuse(fmt::format("has heights in \"{}\"", name), "Talus needs metres",
                      "If they are metres, drop the name: " + command_to_metres_of_height(1, crs, problems));
    }
  };
  const auto of_crs = crs ? unit_of_height(*crs) : std::nullopt;
  if (!unit.empty()) {
    const auto metres = metres_of_unit(unit);
    if (metres && of_crs && std::abs(*metres - of_crs->metres) > 1e-9) {
      problems.refuse(fmt::format("has heights in {} and in {}", unit, of_crs->name),
                      fmt::format("its band says one, {} the other", name_of(*crs)),
                      "Say what they are: " + problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif") +
                          ", or gdal_edit.py -units");
      return;
    }
    if (!metres || *metres != 1) refuse(unit, metres);
  } else if (of_crs && std::abs(of_crs->metres - 1) > 1e-9) {
    refuse(of_crs->name, of_crs->metres);
  }
}

void judge_band(GDALRasterBand& band, RasterProblems& problems) {
  if (GDALDataTypeIsComplex(band.GetRasterDataType())) {
    problems.refuse("has complex numbers in band 1", "an elevation is a real number",
                    "Keep their real part: " + problems.command("gdal_translate -ot Float32", "_real.tif"));
  }
  int has_scale = 0, has_offset = 0;
  const double scale = band.GetScale(&has_scale), offset = band.GetOffset(&has_offset);
  if ((has_scale && (!std::isfinite(scale) || scale == 0)) || (has_offset && !std::isfinite(offset))) {
    problems.refuse(fmt::format("has the scale {:g} and the offset {:g} for its heights", scale, offset),
                    "all cells would have one height, or none",
                    "Leave them out: " + problems.command("gdal_translate -a_scale 1 -a_offset 0", "_heights.tif"));
  }
  const GDALColorInterp colour = band.GetColorInterpretation();
  if (colour != GCI_Undefined && colour != GCI_GrayIndex) {
    const std::string word = GDALGetColorInterpretationName(colour);
    problems.refuse("is a picture",
                    fmt::format("band 1 is the colour component \"{}\"; Talus needs elevations there", word),
                    "If it does hold them: " +
                        problems.command("gdal_translate -b 1 -ot Float32 -colorinterp_1 gray", "_heights.tif"));
  }
}

/// Reads the band and turns it north up.
class BandReader {
 public:
  BandReader(GDALRasterBand& band, const Placing& placing, GdalMessages& messages, RasterProblems& problems)
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
    judge_values(out);
  }

 private:
  void read_rows(RasterGrid& grid) {
    const int columns = band_.GetXSize(), rows = band_.GetYSize();
    int block_columns = 0, block_rows = 0;
    band_.GetBlockSize(&block_columns, &block_rows);
    const std::int64_t bytes_of_row = std::int64_t{columns} * GDALGetDataTypeSizeBytes(band_.GetRasterDataType());
    // All blocks that some rows lie in stay at hand while those are read, whatever the shape of the blocks.
    const BlockMemory memory(std::max<std::int64_t>(std::int64_t{64} << 20, 2 * bytes_of_row * block_rows));
    const std::int64_t most_rows = std::max<std::int64_t>(1, (std::int64_t{32} << 20) / (8 * std::int64_t{columns}));
    const int at_once =
        static_cast<int>(std::min<std::int64_t>(block_rows * (1 + most_rows / (2 * block_rows)), most_rows));

    const bool has_mask = (band_.GetMaskFlags() & GMF_ALL_VALID) == 0;
    int has_scale = 0, has_offset = 0;
    const double scale = band_.GetScale(&has_scale), offset = band_.GetOffset(&has_offset);
    scale_ = has_scale ? scale : 1;
    offset_ = has_offset ? offset : 0;

    values_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(at_once));
    if (has_mask) mask_.resize(values_.size());
    for (int first = 0; first < rows; first += at_once) {
      const int count = std::min(at_once, rows - first);
      fetch(band_, first, count, values_.data(), GDT_Float64);
      if (has_mask) fetch(*band_.GetMaskBand(), first, count, mask_.data(), GDT_Byte);
      for (int k = 0; k < count; ++k) {
        const auto row = static_cast<std::uint32_t>(placing_.from_south ? first + k : rows - 1 - first - k);
        float* to = grid.z.data() + grid.index(0, row);
        convert(static_cast<std::size_t>(k) * grid.columns, grid.columns, to);
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
    problems_.stop("cannot be read to its end", messages_.failure(), "Copy it again from where it comes from");
  }

  void convert(std::size_t from, std::size_t count, float* to) const {
    constexpr double largest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < count; ++i) {
      const double z = values_[from + i] * scale_ + offset_;
      const bool has_data = std::abs(z) <= largest && (mask_.empty() || mask_[from + i] != 0);
      to[i] = has_data ? static_cast<float>(z) : none;
    }
  }

  void judge_values(RasterFile& out) {
    std::uint64_t strange = 0;
    double strangest = 0;
    for (const float z : out.grid.z) {
      if (std::isnan(z)) {
        ++out.without_data;
      } else if (z < lowest_elevation_m || z > highest_elevation_m) {
        ++strange;
        if (std::abs(z) > std::abs(strangest)) strangest = z;
      }
    }
    if (strange > 0) {
      problems_.stop(fmt::format("has elevations such as {:.10g} m", strangest),
                     fmt::format("{} of {} cells are below {:g} m or above {:g} m; they seem to have no data, but the "
                                 "file does not say so",
                                 strange, out.grid.z.size(), lowest_elevation_m, highest_elevation_m),
                     "Tell it: " + problems_.command(fmt::format("gdal_translate -a_nodata {:.17g}", raw(strangest)),
                                                     "_declared.tif"));
    }
    judge_zeros(out.grid);
    if (!has_surface(out.grid)) {
      problems_.stop("has no surface",
                     out.without_data == out.grid.z.size()
                         ? "no cell has data"
                         : "nowhere have four neighbouring cells data, which a piece of surface needs");
    }
  }

  /// Zeros at the foot of walls are not ground: no data that the file does not declare. (The sea and a lowest point of
  /// 0 have beaches.)
  void judge_zeros(const RasterGrid& grid) {
    constexpr double wall = 5;  // height over width
    std::uint64_t zeros = 0, borders = 0, walls = 0;
    const auto look = [&](std::size_t node, std::size_t next, double apart) {
      const float a = grid.z[node], b = grid.z[next];
      if ((a == 0) == (b == 0) || std::isnan(a + b)) return;
      ++borders;
      walls += std::abs(a - b) > wall * apart ? 1 : 0;
    };
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        const std::size_t node = grid.index(i, row);
        zeros += grid.z[node] == 0 ? 1 : 0;
        if (i + 1 < grid.columns) look(node, node + 1, grid.dx);
        if (row + 1 < grid.rows) look(node, node + grid.columns, grid.dy);
      }
    }
    if (2 * walls <= borders) return;
    problems_.warn(
        fmt::format("has {} cells of 0 m", zeros),
        "walls stand around them; they seem to have no data, but the file does not say so",
        "Tell it: " + problems_.command(fmt::format("gdal_translate -a_nodata {:.17g}", raw(0)), "_declared.tif"));
  }

  /// As the file has it, before scale and offset.
  [[nodiscard]] double raw(double z) const { return (z - offset_) / scale_; }

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
  const Placing& placing_;
  GdalMessages& messages_;
  RasterProblems& problems_;
  double scale_ = 1, offset_ = 0;
  std::vector<double> values_;
  std::vector<std::uint8_t> mask_;
};

}  // namespace

bool can_read_rasters() { return true; }

RasterFile read_raster_file(const std::filesystem::path& path, Problems& warnings, const ProjectCrs& said) {
  GdalMessages messages;
  RasterProblems problems(path);
  const GDALDatasetUniquePtr dataset = open_raster(messages, problems);
  GDALRasterBand& band = *dataset->GetRasterBand(1);

  judge_size(*dataset, problems);
  const auto place = placing(*dataset, problems);
  const std::optional<OGRSpatialReference> named = crs_of(*dataset, said, messages, problems);
  const OGRSpatialReference* const crs = named ? &*named : nullptr;
  std::optional<Vec2> centre;
  double t[6];
  if (dataset->GetGeoTransform(t) == CE_None) {
    const double i = 0.5 * band.GetXSize(), j = 0.5 * band.GetYSize();
    centre = Vec2(t[0] + t[1] * i + t[2] * j, t[3] + t[4] * i + t[5] * j);
  }
  judge_band(band, problems);
  // Before the plan: a projected copy would no longer say what unit its heights are in.
  judge_unit(band, crs, problems);
  if (place) judge_place(*dataset, *place, crs, said.is_local, problems);
  if (crs) check_terrain_crs(*crs, centre, problems);
  problems.throw_if_any();

  RasterFile out;
  if (crs) {
    out.crs_wkt = wkt_of(*crs);
    out.crs_name = name_of(*crs);
  } else if (!said.is_local) {
    problems.warn("names no coordinate system",
                  fmt::format("its cells are taken to be {:.6g} x {:.6g} m", place->dx, place->dy),
                  "Name it: crs = \"EPSG:XXXX\" in [terrain], or \"local\" for metres of no map");
  }
  if (band.GetRasterDataType() == GDT_Byte) {
    problems.warn("has elevations of 8 bits, whole numbers from 0 to 255",
                  "so has a hillshade or another picture; few DEMs do",
                  "Name the raster of elevations that it was made from");
  }
  warn_of_further_bands(*dataset, problems);
  BandReader(band, *place, messages, problems).into(out);
  warnings.append(problems.warnings());
  return out;
}

}  // namespace talus

#else

namespace talus {

bool can_read_rasters() { return false; }

RasterFile read_raster_file(const std::filesystem::path& path, Problems&, const ProjectCrs&) {
  throw BadInput(Problem{.file = path.string(),
                         .where = {},
                         .what = "cannot be read",
                         .why = "this build of Talus has no GDAL",
                         .hint = "Build it with GDAL: cmake --preset release -DTALUS_GDAL=ON"});
}

}  // namespace talus

#endif
