#ifdef TALUS_HAS_GDAL

#include "talus/gdal/gdal_raster.hpp"

#include <cpl_error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "talus/gdal/ascii_grid_check.hpp"
#include "talus/gdal/gdal_open.hpp"

namespace talus {

namespace {

Problem problem(const std::filesystem::path& file, std::string what, std::string why, std::string hint) {
  return {.file = file.string(), .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)};
}

GridNumbers numbers_of(GDALDataset& dataset) {
  const bool is_whole = dataset.GetRasterCount() > 0 && dataset.GetRasterBand(1)->GetRasterDataType() == GDT_Int32;
  return is_whole ? GridNumbers::whole : GridNumbers::real;
}

}  // namespace

std::string shell_word(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c >= 128 ||
           std::string_view("/._-+=:,@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

GdalMessages::GdalMessages(GdalFiles files) : files_(std::move(files)) {
  start_gdal();
  CPLPushErrorHandlerEx(&note, this);
}

GdalMessages::~GdalMessages() { CPLPopErrorHandler(); }

void GdalMessages::note(CPLErr severity, CPLErrorNum, const char* message) {
  auto& self = *static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  if (severity >= CE_Failure && self.failure_.empty()) self.failure_ = *message ? message : "no reason was given";
}

std::string GdalMessages::failure() const {
  if (failure_.empty()) return "GDAL gives no reason";
  std::string out = "GDAL: " + failure_;
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  while (out.back() == ' ' || out.back() == '.') out.pop_back();
  return out;
}

void RasterProblems::refuse(std::string what, std::string why, std::string hint) {
  refusals_.add(problem(file_, std::move(what), std::move(why), std::move(hint)));
}

void RasterProblems::stop(std::string what, std::string why, std::string hint) {
  refuse(std::move(what), std::move(why), std::move(hint));
  throw BadInput(refusals_);
}

void RasterProblems::warn(std::string what, std::string why, std::string hint) {
  Problem warning = problem(file_, std::move(what), std::move(why), std::move(hint));
  warning.severity = Severity::warning;
  warnings_.add(std::move(warning));
}

void RasterProblems::throw_if_any() const {
  if (refusals_.has_errors()) throw BadInput(refusals_);
}

std::string RasterProblems::command(std::string_view before, std::string_view ending) const {
  std::filesystem::path made = file_;
  made.replace_filename(file_.stem().string() + std::string(ending));
  return fmt::format("{} {} {}", before, shell_word(file_.string()), shell_word(made.string()));
}

GDALDatasetUniquePtr open_raster(GdalMessages& messages, RasterProblems& problems, GdalKind kind) {
  GDALDatasetUniquePtr dataset;
  try {
    dataset = open_with_gdal(kind, messages, problems);
  } catch (const BadInput&) {
    if (is_ascii_grid(problems.file())) check_ascii_grid(problems.file(), GridNumbers::real);
    throw;
  }
  if (is_ascii_grid(problems.file())) check_ascii_grid(problems.file(), numbers_of(*dataset));
  if (dataset->GetRasterCount() > 0) return dataset;
  const CSLConstList parts = dataset->GetMetadata("SUBDATASETS");
  const char* first = CSLFetchNameValue(parts, "SUBDATASET_1_NAME");
  if (first) {
    const std::string command = fmt::format("gdal_translate {}", shell_word(first));
    const std::string whole = problems.command("", "_part.tif");
    problems.stop("is a collection of rasters", fmt::format("the first is named {}", first),
                  "Extract one: " + command + whole.substr(whole.rfind(' ')));
  }
  problems.stop("has no band", "expected one or more");
}

void warn_of_further_bands(GDALDataset& dataset, RasterProblems& problems) {
  if (dataset.GetRasterCount() < 2 || dataset.GetRasterBand(2)->GetColorInterpretation() == GCI_AlphaBand) return;
  problems.warn(fmt::format("has {} bands", dataset.GetRasterCount()), "Talus reads the first");
}

bool read_geotransform(GDALDataset& dataset, double (&geotransform)[6], RasterProblems& problems) {
  if (dataset.GetGeoTransform(geotransform) != CE_None) {
    if (dataset.GetGCPCount() > 0) {
      problems.refuse("has no regular grid on the map",
                      fmt::format("it is georeferenced by {} control points", dataset.GetGCPCount()),
                      "Resample it: " + problems.command("gdalwarp -r bilinear", "_grid.tif"));
    } else {
      problems.refuse(
          "is not georeferenced", "it has no geotransform: neither a corner nor a cell size",
          "Assign its extent: " + problems.command("gdal_translate -a_ullr WEST NORTH EAST SOUTH", "_placed.tif"));
    }
    return false;
  }
  const double area = geotransform[1] * geotransform[5] - geotransform[2] * geotransform[4];
  if (!std::isfinite(area) || area == 0 || !std::isfinite(geotransform[0]) || !std::isfinite(geotransform[3])) {
    problems.refuse(
        "is not georeferenced", fmt::format("its cells are {:g} by {:g} in size", geotransform[1], geotransform[5]),
        "Assign its extent: " + problems.command("gdal_translate -a_ullr WEST NORTH EAST SOUTH", "_placed.tif"));
    return false;
  }
  return true;
}

}  // namespace talus

#endif
