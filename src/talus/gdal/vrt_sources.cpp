#ifdef TALUS_HAS_GDAL

#include "talus/gdal/vrt_sources.hpp"

#include <cpl_minixml.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "talus/files/ordinary_file.hpp"
#include "talus/gdal/gdal_files.hpp"
#include "talus/gdal/gdal_open.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;

constexpr vsi_l_offset largest = vsi_l_offset{256} << 20;  // bytes; each raster of a mosaic takes a few hundred

struct Forget {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};
using Xml = std::unique_ptr<CPLXMLNode, Forget>;

bool is_below(const fs::path& folder, const fs::path& file) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && rest != file.end();
}

class SourceFinder {
 public:
  SourceFinder(GdalMessages& messages, RasterProblems& problems, GdalKind kind)
      : messages_(messages), problems_(problems), kind_(kind) {}

  /// `via`: the chain of references to this VRT, for messages: `refers to "a.vrt", which `.
  void add_sources(const fs::path& vrt, const std::string& via) {
    if (!seen_.insert(vrt.string()).second) return;
    const Xml all = parsed(vrt, via);
    std::vector<const CPLXMLNode*> nodes{all.get()};
    while (!nodes.empty()) {
      const CPLXMLNode* const node = nodes.back();
      nodes.pop_back();
      for (const CPLXMLNode* next : {node->psChild, node->psNext}) {
        if (next != nullptr) nodes.push_back(next);
      }
      if (node->eType == CXT_Attribute && EQUAL(node->pszValue, "subClass")) check_type(*node, via);
      if (node->eType == CXT_Element && EQUAL(node->pszValue, "SourceFilename")) add_source(vrt, *node, via);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& why) {
    problems_.stop(what, why,
                   "Put its rasters next to it. If you trust it: " + problems_.command("gdal_translate", ".tif"));
  }

  Xml parsed(const fs::path& vrt, const std::string& via) {
    VSIStatBufL found;
    if (VSIStatL(vrt.c_str(), &found) != 0 || static_cast<vsi_l_offset>(found.st_size) > largest) {
      refuse(via + "cannot be read", fmt::format("a VRT may have at most {} MB", largest >> 20));
    }
    messages_.clear();
    Xml all(CPLParseXMLFile(vrt.c_str()));
    if (!all) refuse(via + "cannot be read", messages_.failure());
    return all;
  }

  void check_type(const CPLXMLNode& attribute, const std::string& via) {
    const std::string type = attribute.psChild != nullptr ? attribute.psChild->pszValue : "";
    if (EQUAL(type.c_str(), "VRTSourcedRasterBand")) return;
    refuse(fmt::format("{}is a virtual raster of the type {}", via, type),
           "Talus reads mosaics of rasters, as made by gdalbuildvrt");
  }

  void add_source(const fs::path& vrt, const CPLXMLNode& node, const std::string& via) {
    const std::string name = CPLGetXMLValue(&node, nullptr, "");
    const bool is_relative = CPLTestBool(CPLGetXMLValue(&node, "relativeToVRT", "0"));
    const fs::path place = is_relative ? vrt.parent_path() / name : fs::path(name);
    const std::string reference = fmt::format("{}refers to \"{}\"", via, name);
    const auto why = is_name_of_gdal(vrt.string()) ? fault_in_archive(vrt, place) : fault_on_disk(vrt, place);
    if (!why.empty()) refuse(reference, why);
    messages_.files().add(place);
    const std::string driver = driver_of(place.string(), kind_);
    if (driver.empty()) refuse(reference, "that is not a raster that Talus reads");
    if (driver == "VRT") add_sources(place, reference + ", which ");
  }

  static constexpr const char* elsewhere = "a VRT may refer only to rasters in its own folder or below it";

  static std::string fault_on_disk(const fs::path& vrt, const fs::path& place) {
    std::error_code error;
    const fs::path folder = fs::canonical(fs::absolute(vrt).parent_path(), error);
    if (error || place.empty()) return elsewhere;
    const fs::path file = fs::weakly_canonical(place, error);
    if (error || !is_below(folder, fs::absolute(file))) return elsewhere;
    if (!fs::exists(file, error)) return "there is no such file";
    if (const auto why = not_an_ordinary_file(file)) return *why;
    return {};
  }

  /// Members of an archive cannot be links.
  static std::string fault_in_archive(const fs::path& vrt, const fs::path& place) {
    if (!is_below(vrt.parent_path(), place.lexically_normal())) return elsewhere;
    VSIStatBufL found;
    return VSIStatL(place.c_str(), &found) == 0 ? "" : "there is no such file";
  }

  GdalMessages& messages_;
  RasterProblems& problems_;
  GdalKind kind_;
  std::set<std::string> seen_;
};

}  // namespace

std::string driver_of(const std::string& name, GdalKind kind) {
  const auto drivers = drivers_that_read(kind);
  const unsigned flags = kind == GdalKind::vector ? unsigned{GDAL_OF_VECTOR} : unsigned{GDAL_OF_RASTER};
  GDALDriverH driver = GDALIdentifyDriverEx(name.c_str(), flags, drivers.data(), nullptr);
  return driver != nullptr ? GDALGetDriverShortName(driver) : "";
}

void bring_sources_into_reach(GdalMessages& messages, RasterProblems& problems, GdalKind kind) {
  SourceFinder(messages, problems, kind).add_sources(name_for_gdal(problems.file()), "");
}

}  // namespace talus

#endif
