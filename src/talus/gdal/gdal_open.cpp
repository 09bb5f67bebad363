#ifdef TALUS_HAS_GDAL

#include "talus/gdal/gdal_open.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <array>
#include <system_error>

#include "talus/core/stop.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/gdal/gdal_files.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/gdal/vrt_sources.hpp"

namespace talus {

namespace {

void expect_file(RasterProblems& problems) {
  const std::filesystem::path& file = problems.file();
  const bool is_in_archive = is_name_of_gdal(file.string());
  if (is_in_archive && !is_archive_name(file.string())) {
    problems.stop("cannot be read",
                  "of GDAL's virtual file systems Talus reads only /vsizip/ and /vsigzip/ of files on disk",
                  "Copy it to disk and use that file");
  }
  std::error_code error;
  const auto on_disk = file_on_disk(file, error);
  if (!on_disk) {
    problems.stop("cannot be read", error ? error.message() : "there is no such file",
                  "Paths are relative to the project file");
  }
  if (std::filesystem::is_directory(*on_disk, error)) return;  // a folder of Shapefiles
  if (const auto why = not_an_ordinary_file(*on_disk)) problems.stop("cannot be read", *why, "Name a file");
}

/// SQLite opens these beside a database by itself, and would wait for a pipe.
void expect_ordinary_side_files(RasterProblems& problems) {
  std::error_code error;
  const auto file = file_on_disk(problems.file(), error);
  if (!file) return;
  for (const std::filesystem::path& database : {*file, std::filesystem::weakly_canonical(*file, error)}) {
    for (const char* ending : {"-journal", "-wal", "-shm"}) {
      const std::filesystem::path side = database.string() + ending;
      if (const auto why = not_an_ordinary_file(side))
        problems.stop("cannot be read", fmt::format("\"{}\" belongs to it, but {}", side.filename().string(), *why),
                      "Remove it");
    }
  }
}

void limit_queries(GdalMessages& messages, const std::filesystem::path& name) {
  std::error_code error;
  const auto file = file_on_disk(name, error);
  const auto bytes = file ? std::filesystem::file_size(*file, error) : 0;
  messages.queries().allow_for(error ? 0 : bytes);
}

/// The first element of an XML file, such as "<GDAL_WMS>"; empty for other files.
std::string first_element(const std::string& name) {
  std::array<char, 512> bytes{};
  VSILFILE* const file = VSIFOpenL(name.c_str(), "rb");
  if (file == nullptr) return {};
  const std::string head(bytes.data(), VSIFReadL(bytes.data(), 1, bytes.size(), file));
  VSIFCloseL(file);
  std::size_t begin = head.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || head[begin] != '<') return {};
  while (begin != std::string::npos && begin + 1 < head.size() && (head[begin + 1] == '?' || head[begin + 1] == '!')) {
    begin = head.find('<', begin + 1);
  }
  if (begin == std::string::npos) return "XML";
  const std::size_t end = head.find_first_of(" \t\r\n/>", begin + 1);
  return end == std::string::npos ? "XML" : head.substr(begin, end - begin) + ">";
}

/// GDAL treats files that it cannot open as missing, and continues without them.
void expect_all_opened(RasterProblems& problems) {
  if (const auto why = failure_of_disk()) problems.stop("cannot be read", *why);
}

}  // namespace

std::string name_for_gdal(const std::filesystem::path& file) {
  return file.is_absolute() ? file.string() : (std::filesystem::path(".") / file).string();
}

void expect_end_of_queries(GdalMessages& messages, RasterProblems& problems) {
  if (!messages.queries().is_reached()) return;
  problems.stop("has a view that does not end", "its query took more steps than a file of this size can need",
                "Copy the features that you need to a table of their own");
}

std::vector<const char*> drivers_that_read(GdalKind kind) {
  std::vector<const char*> drivers;
  for (const GdalFormat& format : formats_read(kind)) drivers.push_back(format.driver);
  drivers.push_back(nullptr);
  return drivers;
}

std::string format_of_file(GdalKind kind, GdalMessages& messages, RasterProblems& problems) {
  expect_file(problems);
  messages.files().add(problems.file());
  return driver_of(name_for_gdal(problems.file()), kind);
}

GDALDatasetUniquePtr open_with_gdal(GdalKind kind, GdalMessages& messages, RasterProblems& problems,
                                    const char* const* options) {
  expect_file(problems);
  messages.files().add(problems.file());
  if (kind == GdalKind::vector) {
    expect_ordinary_side_files(problems);
    limit_queries(messages, problems.file());
  }
  const std::string name = name_for_gdal(problems.file());
  if (const auto fault = fault_of_proj(messages)) problems.stop(fault->what, fault->why, fault->hint);
  (void)failure_of_disk();
  if (driver_of(name, kind) == "VRT") bring_sources_into_reach(messages, problems, kind);
  messages.clear();
  const unsigned flags = GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR |
                         (kind == GdalKind::vector ? unsigned{GDAL_OF_VECTOR} : unsigned{GDAL_OF_RASTER});
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(name.c_str(), flags, drivers_that_read(kind).data(), options, nullptr));
  stop_point();  // an interruption is not an error in the file
  expect_end_of_queries(messages, problems);
  expect_all_opened(problems);
  if (dataset) return dataset;
  const std::string element = first_element(name);
  problems.stop(kind == GdalKind::vector ? "is not a vector file that Talus reads" : "is not a raster that Talus reads",
                element.empty() ? messages.failure() : fmt::format("it begins with {}", element),
                fmt::format("Talus reads {}", names_of_formats(kind)));
}

}  // namespace talus

#endif
