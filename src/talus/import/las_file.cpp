#include "talus/import/las_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include "talus/core/stop.hpp"
#include "talus/import/raster_file.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus {
namespace {

static_assert(std::endian::native == std::endian::little,
              "LAS is little-endian, and its numbers are copied without conversion");

constexpr std::uint64_t most_las_points = std::uint64_t{1} << 30U;
constexpr std::uint64_t longest_record = 1 << 20;  // bytes; coordinate systems take a few kilobytes
constexpr std::size_t shortest_header = 227, header_of_14 = 375;
// The minimum number of bytes of a point, by format.
constexpr std::array<std::uint16_t, 11> least_length{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

template <class Number>
Number number_at(const std::vector<char>& bytes, std::size_t at) {
  Number value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::string text_at(const std::vector<char>& bytes, std::size_t at, std::size_t length) {
  std::string text(bytes.data() + at, length);
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

class LasReader {
 public:
  LasReader(const std::filesystem::path& path, const std::vector<std::int64_t>& classes)
      : path_(path), classes_(classes) {}

  LasFile read() {
    open();
    read_header();
    read_records();
    read_points();
    return std::move(las_);
  }

 private:
  [[noreturn]] void stop(std::string what, std::string why, std::string hint = "") const {
    throw BadInput(Problem{
        .file = path_.string(), .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)});
  }

  void open() {
    std::error_code error;
    const auto status = std::filesystem::status(path_, error);
    if (error) stop("cannot be read", error.message(), "Paths are relative to the project file");
    if (!std::filesystem::is_regular_file(status)) stop("cannot be read", "it is not an ordinary file");
    size_ = std::filesystem::file_size(path_, error);
    stream_.open(path_, std::ios::binary);
    if (error || !stream_) stop("cannot be read", "it cannot be opened");
  }

  std::vector<char> bytes(std::uint64_t from, std::uint64_t count) {
    std::vector<char> out(count);
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(from));
    stream_.read(out.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::uint64_t>(stream_.gcount()) != count) {
      stop("is cut short", fmt::format("bytes {} to {} are missing; it has {} bytes", from, from + count, size_),
           "Copy it again from its source");
    }
    return out;
  }

  void read_header() {
    if (size_ < shortest_header) stop("is not a LAS file", fmt::format("its {} bytes are less than a header", size_));
    const auto header = bytes(0, std::min<std::uint64_t>(size_, header_of_14));
    if (std::string_view(header.data(), 4) != "LASF") stop("is not a LAS file", "it does not begin with LASF");
    const int major = header[24], minor = header[25];
    if (major != 1 || minor < 0 || minor > 4) {
      stop(fmt::format("is LAS {}.{}", major, minor), "Talus reads 1.0 to 1.4");
    }
    const auto format = number_at<std::uint8_t>(header, 104);
    if ((format & 0xC0U) != 0) {
      const std::string stem = (path_.parent_path() / path_.stem()).string();
      stop("is compressed (LAZ)", "Talus reads LAS",
           fmt::format("Unpack it: pdal translate {} {}_unpacked.las", path_.string(), stem));
    }
    if (format >= least_length.size()) {
      stop(fmt::format("has points of format {}", format),
           fmt::format("Talus reads formats 0 to {}", least_length.size() - 1));
    }
    format_ = format;
    length_ = number_at<std::uint16_t>(header, 105);
    if (length_ < least_length[format_]) {
      stop(fmt::format("has points of {} bytes", length_),
           fmt::format("those of format {} have {} or more", format_, least_length[format_]));
    }
    first_ = number_at<std::uint32_t>(header, 96);
    las_.declared = number_at<std::uint32_t>(header, 107);
    record_count_ = number_at<std::uint32_t>(header, 100);
    header_size_ = number_at<std::uint16_t>(header, 94);
    if (minor == 4 && header.size() == header_of_14) {
      las_.declared = std::max(las_.declared, number_at<std::uint64_t>(header, 247));
      long_records_at_ = number_at<std::uint64_t>(header, 235);
      long_record_count_ = number_at<std::uint32_t>(header, 243);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scale_[axis] = number_at<double>(header, 131 + 8 * axis);
      offset_[axis] = number_at<double>(header, 155 + 8 * axis);
    }
    if (!scale_.is_finite() || !offset_.is_finite() || !(std::min({scale_.x(), scale_.y(), scale_.z()}) > 0)) {
      stop(fmt::format("has the scales {:g}, {:g}, {:g} and the offsets {:g}, {:g}, {:g}", scale_.x(), scale_.y(),
                       scale_.z(), offset_.x(), offset_.y(), offset_.z()),
           "scales must be more than 0, and all must be finite");
    }
    // The largest possible coordinates: 2^31 times the scale, plus the offset.
    const Vec3 farthest = 2147483648.0 * scale_ + offset_.abs();
    if (!farthest.is_finite()) {
      stop(fmt::format("has the scales {:g}, {:g}, {:g} and the offsets {:g}, {:g}, {:g}", scale_.x(), scale_.y(),
                       scale_.z(), offset_.x(), offset_.y(), offset_.z()),
           "its coordinates would not be finite");
    }
    if (las_.declared == 0) stop("has no points", "its header says so");
    if (las_.declared >= most_las_points) {
      stop(fmt::format("declares {} points", las_.declared), fmt::format("Talus reads fewer than {}", most_las_points),
           "Thin it, cut it to the slope, or make a raster from it");
    }
    if (first_ > size_ || las_.declared > (size_ - first_) / length_) {
      stop(fmt::format("declares {} points of {} bytes from byte {}", las_.declared, length_, first_),
           fmt::format("it has {} bytes", size_), "Copy it again from its source");
    }
  }

  // Reads the coordinate system from the records between header and points and, since 1.4, after the points.
  void read_records() {
    std::uint64_t at = header_size_;
    for (std::uint32_t k = 0; k < record_count_ && at + 54 <= first_; ++k) {
      const auto head = bytes(at, 54);
      const auto length = number_at<std::uint16_t>(head, 20);
      if (at + 54 + length > first_) break;
      read_record(text_at(head, 2, 16), number_at<std::uint16_t>(head, 18), at + 54, length);
      at += 54 + std::uint64_t{length};
    }
    at = long_records_at_;
    for (std::uint32_t k = 0; k < long_record_count_ && at >= first_ && at < size_ && size_ - at >= 60; ++k) {
      const auto head = bytes(at, 60);
      const auto length = number_at<std::uint64_t>(head, 20);
      if (length > size_ - at - 60) break;
      read_record(text_at(head, 2, 16), number_at<std::uint16_t>(head, 18), at + 60, length);
      at += 60 + length;
    }
  }

  void read_record(const std::string& user, int number, std::uint64_t at, std::uint64_t length) {
    if (user != "LASF_Projection" || length > longest_record) return;
    const auto record = bytes(at, length);
    if (number == 2112) las_.crs.wkt = text_at(record, 0, record.size());
    if (number != 34735) return;
    // GeoTIFF's GeoKeyDirectoryTag: a header of four 16-bit numbers, then four for each key. The second of them is the
    // location of the value; 0 means that the fourth is the value.
    for (std::size_t key = 8; key + 8 <= record.size(); key += 8) {
      if (number_at<std::uint16_t>(record, key + 2) != 0) continue;
      const int value = number_at<std::uint16_t>(record, key + 6);
      const bool is_code = value != 0 && value != 32767;  // 32767: user-defined
      const auto code = is_code ? std::optional<int>(value) : std::nullopt;
      switch (number_at<std::uint16_t>(record, key)) {
        case 1024:
          las_.crs.is_geographic = value == 2;
          break;
        case 2048:
          las_.crs.geographic_epsg = code;
          break;
        case 3072:
          las_.crs.projected_epsg = code;
          break;
        case 3076:
          las_.crs.plan_unit_epsg = code;
          break;
        case 4096:
          las_.crs.vertical_epsg = code;
          break;
        case 4099:
          las_.crs.vertical_unit_epsg = code;
          break;
        default:
          break;
      }
    }
  }

  [[nodiscard]] bool wants(int las_class) const {
    if (classes_.empty()) return !is_noise(las_class);
    return std::find(classes_.begin(), classes_.end(), las_class) != classes_.end();
  }

  void read_points() {
    // Classification and flags: the specification's tables 7 to 9 (formats 0 to 5) and 10 to 16 (6 to 10).
    const bool is_new_format = format_ >= 6;
    constexpr std::uint64_t block_size = 1 << 16;  // points
    std::uint64_t impossible = 0, far_away = 0;
    double impossible_height = 0, farthest = 0;
    for (std::uint64_t done = 0; done < las_.declared; done += block_size) {
      stop_point();
      const std::uint64_t count = std::min(block_size, las_.declared - done);
      const auto block = bytes(first_ + done * length_, count * length_);
      for (std::uint64_t k = 0; k < count; ++k) {
        const std::size_t at = k * length_;
        const auto class_byte = number_at<std::uint8_t>(block, at + (is_new_format ? 16 : 15));
        const int las_class = is_new_format ? class_byte : class_byte & 31U;
        const bool is_withheld = is_new_format ? (number_at<std::uint8_t>(block, at + 15) & 4U) != 0 : class_byte >> 7U;
        if (is_withheld) {
          ++las_.withheld;
          continue;
        }
        ++las_.of_class[las_class];
        if (!wants(las_class)) continue;
        const Vec3 steps(number_at<std::int32_t>(block, at), number_at<std::int32_t>(block, at + 4),
                         number_at<std::int32_t>(block, at + 8));
        las_.points.emplace_back(scale_.times(steps) + offset_);
        const double plan = las_.points.back().xy().abs().largest();
        if (plan > largest_coordinate_m) {
          ++far_away;
          farthest = plan;
        }
        const double z = las_.points.back().z();
        if (z >= lowest_elevation_m && z <= highest_elevation_m) continue;
        ++impossible;
        impossible_height = z;
      }
    }
    if (far_away > 0) {
      stop(fmt::format("has coordinates such as {:.10g}", farthest),
           fmt::format("{} of {} points are further than {:g} m from the origin", far_away, las_.points.size(),
                       largest_coordinate_m),
           "Its scales or offsets are wrong; copy it again from where it comes from");
    }
    if (impossible > 0) {
      stop(fmt::format("has heights such as {:.10g} m", impossible_height),
           fmt::format("{} of {} points are below {:g} m or above {:g} m", impossible, las_.points.size(),
                       lowest_elevation_m, highest_elevation_m),
           "Choose the ground with point_classes, or filter the file");
    }
    if (!las_.points.empty()) return;
    std::string found;
    for (const auto& [las_class, points] : las_.of_class) {
      found += fmt::format("{}{} of class {}", found.empty() ? "" : ", ", points, las_class);
    }
    stop(classes_.empty() ? "has only noise" : "has no points of the classes in point_classes",
         found.empty() ? fmt::format("all its {} points are withheld", las_.withheld) : "it has " + found);
  }

  std::filesystem::path path_;
  const std::vector<std::int64_t>& classes_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  LasFile las_;
  std::size_t format_ = 0;
  std::uint64_t length_ = 0, first_ = 0, header_size_ = 0;
  std::uint32_t record_count_ = 0, long_record_count_ = 0;
  std::uint64_t long_records_at_ = 0;
  Vec3 scale_, offset_;
};

}  // namespace

LasFile read_las_file(const std::filesystem::path& path, const std::vector<std::int64_t>& classes) {
  return LasReader(path, classes).read();
}

}  // namespace talus
