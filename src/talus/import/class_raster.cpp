#include "talus/import/class_raster.hpp"

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/core/stop.hpp"
#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/filler_values.hpp"

namespace talus {

namespace {

using Class = std::optional<std::int32_t>;
using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

constexpr double placing_error = 0.05;            // in cells
constexpr std::int64_t largest_window = 4 << 20;  // cells read at a time

struct CellNumber {
  int column, row;
};

// The exact transformation, which GDAL's approximate transformer calls at some points of a row to interpolate between.
int transform_exactly(void* to_file, int, int count, double* x, double* y, double*, int* success) {
  static_cast<OGRCoordinateTransformation*>(to_file)->Transform(count, x, y, nullptr, success);
  return TRUE;
}

}  // namespace

class ClassRaster::Reader {
 public:
  Reader(const std::filesystem::path& path, const std::string& terrain_crs_wkt, Problems& warnings) : problems_(path) {
    GdalMessages messages;
    dataset_ = open_raster(messages, problems_);
    files_ = messages.files();
    band_ = dataset_->GetRasterBand(1);
    if (GDALDataTypeIsComplex(band_->GetRasterDataType())) {
      problems_.refuse("has complex numbers in band 1", "a class is a whole number",
                       "Keep the real part: " + problems_.command("gdal_translate -ot Int32", "_classes.tif"));
    }
    const double scale = band_->GetScale(), offset = band_->GetOffset();
    if (scale != 1 || offset != 0) {
      problems_.refuse(fmt::format("has the scale {:g} and the offset {:g}", scale, offset),
                       "classes are the raw values of cells",
                       "Remove them: " + problems_.command("gdal_translate -a_scale 1 -a_offset 0", "_classes.tif"));
    }
    const GDALColorInterp colour = band_->GetColorInterpretation();
    if (colour != GCI_Undefined && colour != GCI_GrayIndex && colour != GCI_PaletteIndex) {
      problems_.refuse(
          "is a picture",
          fmt::format("band 1 is the colour component \"{}\"; Talus needs classes there",
                      GDALGetColorInterpretationName(colour)),
          "If it does contain them: " + problems_.command("gdal_translate -b 1 -colorinterp_1 gray", "_classes.tif"));
    }
    double geotransform[6];
    if (read_geotransform(*dataset_, geotransform, problems_) && GDALInvGeoTransform(geotransform, from_place_)) {
      cell_ = std::sqrt(std::abs(geotransform[1] * geotransform[5] - geotransform[2] * geotransform[4]));
    }
    find_transformation(terrain_crs_wkt);
    warn_of_further_bands(*dataset_, problems_);
    problems_.throw_if_any();
    warnings.append(problems_.warnings());
  }

  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() {
    const GdalMessages quiet;
    dataset_.reset();
  }

  std::vector<Class> at(std::span<const Vec2> points) {
    GdalMessages messages(files_);
    const auto cells = cells_of(points);
    std::vector<Class> classes(points.size());
    fill(cells, classes, messages);
    return classes;
  }

  std::uint64_t within = 0;
  std::string crs_name;

 private:
  void find_transformation(const std::string& terrain_crs_wkt) {
    const OGRSpatialReference* known = dataset_->GetSpatialRef();
    const std::string assign = problems_.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif");
    if (known && refuse_files_in_crs(*known, problems_, "Assign one without it: " + assign)) return;
    if (known && known->IsEmpty()) known = nullptr;
    if (known) crs_name = name_of(*known);
    if (terrain_crs_wkt.empty()) return;
    if (!known) {
      problems_.warn("has no coordinate system", "that of the terrain is assumed", "Assign it: " + assign);
      return;
    }
    OGRSpatialReference from, to = *known;
    from.importFromWkt(terrain_crs_wkt.c_str());
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (from.IsSame(&to)) return;
    to_file_.reset(OGRCreateCoordinateTransformation(&from, &to));
    if (!to_file_) {
      problems_.refuse(fmt::format("is in {}", crs_name),
                       fmt::format("there is no transformation to it from {}, that of the terrain", name_of(from)),
                       "Assign the right one: " + assign);
    }
  }

  std::vector<std::optional<CellNumber>> cells_of(std::span<const Vec2> points) {
    std::vector<double> x, y;
    x.reserve(points.size());
    y.reserve(points.size());
    for (const Vec2& p : points) {
      x.push_back(p.x());
      y.push_back(p.y());
    }
    std::vector<int> placed(points.size(), TRUE);
    if (to_file_) transform_rows(points, x, y, placed);
    const double *t = from_place_, columns = band_->GetXSize(), rows = band_->GetYSize();
    std::vector<std::optional<CellNumber>> cells(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double column = std::floor(t[0] + t[1] * x[i] + t[2] * y[i]);
      const double row = std::floor(t[3] + t[4] * x[i] + t[5] * y[i]);
      if (!placed[i] || !(column >= 0 && column < columns && row >= 0 && row < rows)) continue;
      cells[i] = CellNumber{static_cast<int>(column), static_cast<int>(row)};
      ++within;
    }
    return cells;
  }

  void transform_rows(std::span<const Vec2> points, std::vector<double>& x, std::vector<double>& y,
                      std::vector<int>& placed) const {
    std::vector<double> z(points.size(), 0);
    void* transformer = GDALCreateApproxTransformer(&transform_exactly, to_file_.get(), placing_error * cell_);
    for (std::size_t first = 0; first < points.size();) {
      std::size_t end = first + 1;
      while (end < points.size() && points[end].y() == points[first].y()) ++end;
      GDALApproxTransform(transformer, FALSE, static_cast<int>(end - first), &x[first], &y[first], &z[first],
                          &placed[first]);
      first = end;
    }
    GDALDestroyApproxTransformer(transformer);
  }

  void fill(std::span<const std::optional<CellNumber>> cells, std::span<Class> classes, GdalMessages& messages) {
    CellNumber low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()}, high{-1, -1};
    for (const auto& cell : cells) {
      if (!cell) continue;
      low = {std::min(low.column, cell->column), std::min(low.row, cell->row)};
      high = {std::max(high.column, cell->column), std::max(high.row, cell->row)};
    }
    if (high.column < 0) return;
    stop_point();
    const int columns = high.column - low.column + 1, rows = high.row - low.row + 1;
    if (std::int64_t{columns} * rows > largest_window && cells.size() > 1) {
      const std::size_t half = cells.size() / 2;
      fill(cells.first(half), classes.first(half), messages);
      fill(cells.subspan(half), classes.subspan(half), messages);
      return;
    }
    values_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    fetch(*band_, low, columns, rows, values_.data(), GDT_Float64, messages);
    const bool has_mask = (band_->GetMaskFlags() & GMF_ALL_VALID) == 0;
    if (has_mask) {
      mask_.resize(values_.size());
      fetch(*band_->GetMaskBand(), low, columns, rows, mask_.data(), GDT_Byte, messages);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!cells[i]) continue;
      const std::size_t at = static_cast<std::size_t>(cells[i]->row - low.row) * static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(cells[i]->column - low.column);
      if ((!has_mask || mask_[at] != 0) && std::isfinite(values_[at])) classes[i] = whole(values_[at]);
    }
  }

  void fetch(GDALRasterBand& band, const CellNumber& low, int columns, int rows, void* to, GDALDataType type,
             GdalMessages& messages) {
    messages.clear();
    const CPLErr result =
        band.RasterIO(GF_Read, low.column, low.row, columns, rows, to, columns, rows, type, 0, 0, nullptr);
    if (result == CE_None && !messages.has_failure()) return;
    problems_.stop("cannot be read completely", messages.failure(), "Copy it again from its source");
  }

  std::int32_t whole(double value) {
    using Limits = std::numeric_limits<std::int32_t>;
    if (may_be_filler(value) && (value < Limits::min() || value > Limits::max())) {
      problems_.stop(
          fmt::format("has the class {:.10g}", value), "it is probably a no-data value that the file does not declare",
          "Declare it: " + problems_.command(fmt::format("gdal_translate -a_nodata {:.17g}", value), "_declared.tif"));
    }
    if (value != std::floor(value) || value < Limits::min() || value > Limits::max()) {
      problems_.stop(fmt::format("has the class {:g}", value), "a class is a whole number of at most 32 bits",
                     "Round them: " + problems_.command("gdal_translate -ot Int32", "_classes.tif"));
    }
    return static_cast<std::int32_t>(value);
  }

  RasterProblems problems_;
  GdalFiles files_;
  GDALDatasetUniquePtr dataset_;
  GDALRasterBand* band_ = nullptr;
  Transformation to_file_;  // from the terrain's coordinates; null if the file has the same
  double from_place_[6] = {};
  double cell_ = 1;  // side of a cell, in the file's unit
  std::vector<double> values_;
  std::vector<std::uint8_t> mask_;
};

ClassRaster::ClassRaster(const std::filesystem::path& path, const std::string& terrain_crs_wkt, Problems& warnings)
    : reader_(std::make_unique<Reader>(path, terrain_crs_wkt, warnings)) {}

std::vector<Class> ClassRaster::at(std::span<const Vec2> points) { return reader_->at(points); }
std::uint64_t ClassRaster::points_within() const { return reader_->within; }
const std::string& ClassRaster::crs_name() const { return reader_->crs_name; }

}  // namespace talus

#else

namespace talus {

class ClassRaster::Reader {};

ClassRaster::ClassRaster(const std::filesystem::path& path, const std::string&, Problems&) {
  throw BadInput(Problem{.file = path.string(),
                         .where = {},
                         .what = "cannot be read",
                         .why = "this build of Talus has no GDAL",
                         .hint = "Build it with GDAL: cmake --preset release -DTALUS_GDAL=ON"});
}

std::vector<std::optional<std::int32_t>> ClassRaster::at(std::span<const Vec2> points) {
  return std::vector<std::optional<std::int32_t>>(points.size());
}
std::uint64_t ClassRaster::points_within() const { return 0; }
const std::string& ClassRaster::crs_name() const {
  static const std::string none;
  return none;
}

}  // namespace talus

#endif

namespace talus {

ClassRaster::ClassRaster(ClassRaster&&) noexcept = default;
ClassRaster& ClassRaster::operator=(ClassRaster&&) noexcept = default;
ClassRaster::~ClassRaster() = default;

}  // namespace talus
