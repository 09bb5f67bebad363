#ifdef TALUS_HAS_GDAL

#include "talus/gdal/gdal_start.hpp"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <utility>

#include "talus/core/stop.hpp"
#include "talus/gdal/gdal_files.hpp"
#include "talus/gdal/proj_files.hpp"

namespace talus {

namespace {

constexpr std::array<GdalFormat, 7> pictures{{{"PNG", "PNG"},
                                              {"JPEG", "JPEG"},
                                              {"GTiff", "GeoTIFF"},
                                              {"AAIGrid", "Esri ASCII grid (.asc)"},
                                              {"EHdr", "Esri float grid (.flt, .bil)"},
                                              {"HFA", "Erdas Imagine (.img)"},
                                              {"VRT", "VRT"}}};
constexpr std::span<const GdalFormat> rasters = std::span<const GdalFormat>(pictures).subspan(2);
constexpr std::array<GdalFormat, 5> vectors{
    {{"GPKG", "GeoPackage"}, {"ESRI Shapefile", "Shapefile"}, {"GeoJSON", "GeoJSON"}, {"DXF", "DXF"}, {"CSV", "CSV"}}};

/// Files may refer to coordinate systems and other resources by an address; none is fetched.
CPLHTTPResult* no_network(const char*, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc, void*, void*) {
  auto* const result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  constexpr const char* why = "Talus does not allow GDAL to use the network";
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup(why);
  CPLError(CE_Failure, CPLE_AppDefined, "%s", why);
  return result;
}

constexpr int interval = 10'000;  // steps of SQLite's virtual machine: less than a millisecond

thread_local QueryLimit* current_limit = nullptr;

/// Queries end at their limit, and when their thread is asked to stop.
int must_end(void*) {
  const bool is_stopped = StopScope::current() != nullptr && StopScope::current()->is_requested();
  return is_stopped || !QueryLimit::count(interval) ? 1 : 0;
}

int make_stoppable(sqlite3* database, const char**, const sqlite3_api_routines*) {
  sqlite3_progress_handler(database, interval, &must_end, nullptr);
  return SQLITE_OK;
}

bool is_shared = false;

void begin() {
  // For every database that GDAL opens from now on, before its first query.
  sqlite3_auto_extension(reinterpret_cast<void (*)()>(&make_stoppable));
  if (!is_shared) CPLHTTPSetFetchCallback(&no_network, nullptr);
  OSRSetPROJEnableNetwork(FALSE);
  guard_gdal_files(is_shared);
  guard_proj_files();
  // A GeoPackage is a database and may contain views and virtual tables: these may use only SQLite's own harmless
  // functions, and no modules that read other files.
  CPLSetConfigOption("SPATIALITE_LOAD", "NO");
  CPLSetConfigOption("OGR_SQLITE_PRAGMA", "trusted_schema=0");
  CPLSetConfigOption("OGR_SQLITE_LOAD_EXTENSIONS", "");
  CPLSetConfigOption("ALLOW_OGR_SQL_FUNCTIONS_FROM_TRIGGER_AND_VIEW", "NO");
  CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
  CPLSetConfigOption("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO");
  GDALRegister_VRT();
  GDALRegister_GTiff();
  GDALRegister_COG();
  GDALRegister_AAIGrid();
  GDALRegister_EHdr();
  GDALRegister_HFA();
  GDALRegister_PNG();
  GDALRegister_JPEG();
  GDALRegister_MEM();
  RegisterOGRGeoPackage();
  RegisterOGRShape();
  RegisterOGRGeoJSON();
  RegisterOGRDXF();
  RegisterOGRCSV();
}

}  // namespace

std::span<const GdalFormat> formats_read(GdalKind kind) {
  switch (kind) {
    case GdalKind::raster:
      return rasters;
    case GdalKind::picture:
      return pictures;
    case GdalKind::vector:
      break;
  }
  return vectors;
}

std::string names_of_formats(GdalKind kind) {
  const auto formats = formats_read(kind);
  std::string names;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (i > 0) names += i + 1 == formats.size() ? " and " : ", ";
    names += formats[i].name;
  }
  return names;
}

QueryLimit::QueryLimit() : before_(std::exchange(current_limit, this)) {}
QueryLimit::~QueryLimit() { current_limit = before_; }

void QueryLimit::allow_for(std::uint64_t bytes) {
  // A row takes some ten steps and more than ten bytes. Views read tables several times; a join of two small tables
  // without an index, their product.
  constexpr std::uint64_t always = 20'000'000, per_byte = 100;
  left_ = always + per_byte * bytes;
}

bool QueryLimit::count(std::uint64_t steps) {
  if (current_limit == nullptr || current_limit->left_ == std::numeric_limits<std::uint64_t>::max()) return true;
  current_limit->left_ -= std::min(steps, current_limit->left_);
  return !current_limit->is_reached();
}

void share_gdal() { is_shared = true; }

void start_gdal() {
  static const bool is_begun = (begin(), true);
  static_cast<void>(is_begun);
}

}  // namespace talus

#endif
