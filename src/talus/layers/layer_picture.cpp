#include "talus/layers/layer_picture.hpp"

#ifdef TALUS_HAS_GDAL

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>

#include "talus/core/stop.hpp"
#include "talus/layers/layer_raster.hpp"

namespace talus {

namespace {

using Bytes = std::vector<std::uint8_t>;

// Viridis (S. van der Walt and N. Smith, 2015, the default of Matplotlib), which also tells apart who sees red and
// green alike.
constexpr std::array<std::array<std::uint8_t, 3>, 9> ramp{{{0x44, 0x01, 0x54},
                                                           {0x47, 0x2d, 0x7b},
                                                           {0x3b, 0x52, 0x8b},
                                                           {0x2c, 0x72, 0x8e},
                                                           {0x21, 0x91, 0x8c},
                                                           {0x28, 0xae, 0x80},
                                                           {0x5e, 0xc9, 0x62},
                                                           {0xad, 0xdc, 0x30},
                                                           {0xfd, 0xe7, 0x25}}};

int go_on(double, const char*, void*) {
  const StopScope* scope = StopScope::current();
  return scope != nullptr && scope->is_requested() ? FALSE : TRUE;
}

/// The numbers of the bands that are drawn.
struct DrawnBands {
  std::vector<int> colours;  // one or three
  int alpha = 0;             // 0: none
  bool has_table = false;    // of colours
  bool are_chosen = false;   // among others: otherwise the raster is warped as it is, from its overviews
};

DrawnBands bands_of(GDALDataset& dataset) {
  const int count = dataset.GetRasterCount();
  DrawnBands drawn;
  std::array<int, 3> named{};
  std::vector<int> others;
  for (int k = 1; k <= count; ++k) {
    const GDALColorInterp meaning = dataset.GetRasterBand(k)->GetColorInterpretation();
    if (meaning == GCI_AlphaBand) {
      drawn.alpha = k;
      continue;
    }
    others.push_back(k);
    if (meaning >= GCI_RedBand && meaning <= GCI_BlueBand) named[static_cast<std::size_t>(meaning - GCI_RedBand)] = k;
  }
  if (others.size() < 3) {
    drawn.colours = {others.empty() ? 1 : others.front()};
    drawn.has_table = dataset.GetRasterBand(drawn.colours[0])->GetColorTable() != nullptr;
  } else if (std::ranges::find(named, 0) == named.end()) {
    drawn.colours.assign(named.begin(), named.end());
  } else {
    drawn.colours.assign(others.begin(), others.begin() + 3);
  }
  constexpr int most_warped = 5;  // bands, red, green, blue, infrared and alpha: more would take too much memory
  drawn.are_chosen = drawn.has_table || count > most_warped || (drawn.alpha > 0 && drawn.alpha < count);
  return drawn;
}

class Painter {
 public:
  Painter(LayerRaster& raster, std::uint32_t most) : raster_(raster), bands_(bands_of(raster.dataset())) {
    const Vec2 size = raster.area().size();
    const double pixel = std::max(raster.cell(), size.largest() / most);
    const auto pixels = [&](double length) {
      return static_cast<std::uint32_t>(std::clamp(std::ceil(length / pixel - 1e-6), 1.0, static_cast<double>(most)));
    };
    picture_.area = raster.area();
    picture_.columns = pixels(size.x());
    picture_.rows = pixels(size.y());
  }

  LayerPicture paint() {
    const GDALDatasetUniquePtr chosen = bands_.are_chosen ? with_drawn_bands() : nullptr;
    const GDALDatasetUniquePtr warped = warp(chosen ? *chosen : raster_.dataset());
    alpha_ = values_of<std::uint8_t>(*warped, warped->GetRasterCount(), GDT_Byte);  // the last one
    rgb_.resize(3 * alpha_.size());
    if (bands_.colours.size() == 3) {
      paint_colours(*warped);
    } else if (const int band = bands_.colours.front(); warped->GetRasterBand(band)->GetRasterDataType() == GDT_Byte) {
      const Bytes grey = values_of<std::uint8_t>(*warped, band, GDT_Byte);
      for (std::size_t k = 0; k < grey.size(); ++k) set(k, {grey[k], grey[k], grey[k]});
    } else {
      paint_values(*warped);
    }
    encode();
    return std::move(picture_);
  }

 private:
  [[noreturn]] void fail() {
    stop_point();
    raster_.problems().stop("cannot be read completely", raster_.messages().failure(), "Copy it again from its source");
  }

  /// The raster as a virtual one of the bands that are drawn, with the colours of a table.
  GDALDatasetUniquePtr with_drawn_bands() {
    CPLStringList options;
    options.AddString("-of");
    options.AddString("VRT");
    const auto add = [&](int band) {
      options.AddString("-b");
      options.AddString(fmt::format("{}", band).c_str());
    };
    for (const int band : bands_.colours) add(band);
    if (bands_.has_table) {
      options.AddString("-expand");
      options.AddString("rgba");
      bands_.colours.resize(3);
    } else if (bands_.alpha > 0) {
      add(bands_.alpha);
    }
    GDALTranslateOptions* const how = GDALTranslateOptionsNew(options.List(), nullptr);
    raster_.messages().clear();
    int is_wrong = FALSE;
    GDALDatasetUniquePtr made(
        GDALDataset::FromHandle(GDALTranslate("", GDALDataset::ToHandle(&raster_.dataset()), how, &is_wrong)));
    GDALTranslateOptionsFree(how);
    if (!made) fail();
    for (std::size_t k = 0; k < bands_.colours.size(); ++k) bands_.colours[k] = static_cast<int>(k) + 1;
    return made;
  }

  GDALDatasetUniquePtr warp(GDALDataset& source) {
    CPLStringList options;
    const auto add = [&](std::initializer_list<std::string> words) {
      for (const std::string& word : words) options.AddString(word.c_str());
    };
    const PlanArea& area = picture_.area;
    const auto number = [](double value) { return fmt::format("{:.17g}", value); };
    add({"-of", "MEM", "-dstalpha", "-r", bands_.has_table ? "near" : "bilinear", "-ovr", "AUTO", "-wm", "64"});
    add({"-te", number(area.low.x()), number(area.low.y()), number(area.high.x()), number(area.high.y())});
    add({"-ts", fmt::format("{}", picture_.columns), fmt::format("{}", picture_.rows)});
    if (!raster_.own_crs().empty()) add({"-s_srs", raster_.own_crs(), "-t_srs", raster_.terrain_crs()});
    GDALWarpAppOptions* const how = GDALWarpAppOptionsNew(options.List(), nullptr);
    GDALWarpAppOptionsSetProgress(how, &go_on, nullptr);
    raster_.messages().clear();
    GDALDatasetH from = GDALDataset::ToHandle(&source);
    int is_wrong = FALSE;
    GDALDatasetUniquePtr made(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &from, how, &is_wrong)));
    GDALWarpAppOptionsFree(how);
    if (!made || raster_.messages().has_failure()) fail();
    return made;
  }

  template <class T>
  std::vector<T> values_of(GDALDataset& dataset, int band, GDALDataType type) {
    const int columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
    std::vector<T> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    if (dataset.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, type, 0, 0,
                                              nullptr) != CE_None)
      fail();
    return values;
  }

  void set(std::size_t pixel, const std::array<std::uint8_t, 3>& colour) {
    std::ranges::copy(colour, rgb_.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
  }

  /// The least and the greatest of the values that are drawn.
  void extend(std::span<const float> values, double& least, double& most) const {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (alpha_[k] == 0 || !std::isfinite(values[k])) continue;
      least = std::min<double>(least, values[k]);
      most = std::max<double>(most, values[k]);
    }
  }

  void paint_colours(GDALDataset& warped) {
    const bool is_8_bit = warped.GetRasterBand(bands_.colours[0])->GetRasterDataType() == GDT_Byte;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    if (!is_8_bit) {
      for (const int band : bands_.colours) extend(values_of<float>(warped, band, GDT_Float32), least, most);
    }
    for (std::size_t colour = 0; colour < 3; ++colour) {
      const int band = bands_.colours[colour];
      if (is_8_bit) {
        const Bytes values = values_of<std::uint8_t>(warped, band, GDT_Byte);
        for (std::size_t k = 0; k < values.size(); ++k) rgb_[3 * k + colour] = values[k];
        continue;
      }
      const auto values = values_of<float>(warped, band, GDT_Float32);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double share = std::isfinite(values[k]) && most > least ? (values[k] - least) / (most - least) : 0;
        rgb_[3 * k + colour] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
      }
    }
  }

  void paint_values(GDALDataset& warped) {
    const auto values = values_of<float>(warped, bands_.colours[0], GDT_Float32);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    extend(values, least, most);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!std::isfinite(values[k])) alpha_[k] = 0;
      if (alpha_[k] == 0) continue;
      constexpr double last = ramp.size() - 1;
      const double place = most > least ? (values[k] - least) / (most - least) * last : 0;
      const auto from = std::min<std::size_t>(static_cast<std::size_t>(place), ramp.size() - 2);
      std::array<std::uint8_t, 3> colour{};
      for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<std::uint8_t>(
            std::lround(std::lerp(ramp[from][c], ramp[from + 1][c], place - static_cast<double>(from))));
      set(k, colour);
    }
    if (least > most) return;  // nothing is drawn
    picture_.least = least;
    picture_.most = most;
    for (const auto& [red, green, blue] : ramp)
      picture_.ramp.push_back(fmt::format("#{:02x}{:02x}{:02x}", red, green, blue));
  }

  void encode() {
    const bool is_opaque = std::ranges::all_of(alpha_, [](std::uint8_t value) { return value == 255; });
    const int columns = static_cast<int>(picture_.columns), rows = static_cast<int>(picture_.rows);
    GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
    const GDALDatasetUniquePtr whole(memory->Create("", columns, rows, is_opaque ? 3 : 4, GDT_Byte, nullptr));
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(is_opaque ? "JPEG" : "PNG");
    if (!whole || driver == nullptr) fail();
    for (int band = 1; band <= 3; ++band) {
      if (whole->GetRasterBand(band)->RasterIO(GF_Write, 0, 0, columns, rows, rgb_.data() + band - 1, columns, rows,
                                               GDT_Byte, 3, GSpacing{3} * columns, nullptr) != CE_None)
        fail();
    }
    if (!is_opaque) {
      GDALRasterBand& alpha = *whole->GetRasterBand(4);
      alpha.SetColorInterpretation(GCI_AlphaBand);
      if (alpha.RasterIO(GF_Write, 0, 0, columns, rows, alpha_.data(), columns, rows, GDT_Byte, 0, 0, nullptr) !=
          CE_None)
        fail();
    }
    static std::atomic<std::uint64_t> number{0};
    const std::string name = fmt::format("/vsimem/talus_layer_{}", ++number);
    CPLStringList options;
    options.SetNameValue(is_opaque ? "QUALITY" : "ZLEVEL", is_opaque ? "88" : "1");
    GDALDatasetUniquePtr written(driver->CreateCopy(name.c_str(), whole.get(), FALSE, options.List(), &go_on, nullptr));
    const bool is_written = written != nullptr;
    written.reset();
    vsi_l_offset size = 0;
    GByte* const bytes = is_written ? VSIGetMemFileBuffer(name.c_str(), &size, TRUE) : nullptr;
    if (bytes == nullptr) fail();
    picture_.bytes.assign(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
    CPLFree(bytes);
    VSIUnlink((name + ".aux.xml").c_str());
    picture_.type = is_opaque ? "image/jpeg" : "image/png";
  }

  LayerRaster& raster_;
  DrawnBands bands_;
  LayerPicture picture_;
  Bytes alpha_, rgb_;
};

}  // namespace

void check_picture(const std::filesystem::path& file, const TerrainOnPlan& terrain, Problems& warnings) {
  warnings.append(LayerRaster(file, terrain).warnings());
}

LayerPicture picture_of_raster(const std::filesystem::path& file, const TerrainOnPlan& terrain, Problems& warnings,
                               std::uint32_t most) {
  LayerRaster raster(file, terrain);
  LayerPicture picture = Painter(raster, most).paint();
  warnings.append(raster.warnings());
  return picture;
}

}  // namespace talus

#else

namespace talus {

namespace {

[[noreturn]] void refuse_without_gdal(const std::filesystem::path& file) {
  throw BadInput(Problem{.file = file.string(),
                         .where = {},
                         .what = "cannot be read",
                         .why = "this build of Talus has no GDAL",
                         .hint = "Build it with GDAL: cmake --preset release -DTALUS_GDAL=ON"});
}

}  // namespace

void check_picture(const std::filesystem::path& file, const TerrainOnPlan&, Problems&) { refuse_without_gdal(file); }

LayerPicture picture_of_raster(const std::filesystem::path& file, const TerrainOnPlan&, Problems&, std::uint32_t) {
  refuse_without_gdal(file);
}

}  // namespace talus

#endif
