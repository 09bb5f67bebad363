#pragma once
// Small LAS files, written byte by byte after the ASPRS specification.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus::testing_tools {

struct LasPoint {
  Vec3 at;
  int las_class = 2;
  bool withheld = false;
};

struct LasSpec {
  int minor = 2;   // of version 1.x
  int format = 0;  // of the points
  int extra_bytes = 0;
  double scale = 0.01;
  Vec3 offset;
  std::vector<LasPoint> points;
  std::vector<std::array<std::uint16_t, 2>> geo_keys;  // key and value
  std::string wkt;
  std::uint64_t declared = 0;  // number of points in the header; 0: the actual number
};

class LasBytes {
 public:
  explicit LasBytes(const LasSpec& spec) {
    const std::size_t header_size = spec.minor == 4 ? 375 : spec.minor == 3 ? 235 : 227;
    static constexpr std::array<std::size_t, 11> lengths{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    const std::size_t length =
        lengths[static_cast<std::size_t>(spec.format & 63)] + static_cast<std::size_t>(spec.extra_bytes);
    bytes_.resize(header_size);
    std::uint32_t records = 0;
    if (!spec.geo_keys.empty()) {
      std::vector<std::uint16_t> keys{1, 1, 0, static_cast<std::uint16_t>(spec.geo_keys.size())};
      for (const auto& [key, value] : spec.geo_keys) keys.insert(keys.end(), {key, 0, 1, value});
      add_record(34735, {reinterpret_cast<const char*>(keys.data()), 2 * keys.size()});
      ++records;
    }
    if (!spec.wkt.empty()) {
      add_record(2112, spec.wkt + std::string(1, '\0'));
      ++records;
    }
    const auto first = static_cast<std::uint32_t>(bytes_.size());
    for (const LasPoint& point : spec.points) {
      const std::size_t at = bytes_.size();
      bytes_.resize(at + length);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        put(at + 4 * axis, static_cast<std::int32_t>(std::lround((point.at[axis] - spec.offset[axis]) / spec.scale)));
      }
      const bool is_new = (spec.format & 63) >= 6;
      put(at + (is_new ? 16 : 15), static_cast<std::uint8_t>(point.las_class | (!is_new && point.withheld ? 128 : 0)));
      if (is_new && point.withheld) put(at + 15, std::uint8_t{4});
    }
    std::memcpy(bytes_.data(), "LASF", 4);
    put(24, std::uint8_t{1});
    put(25, static_cast<std::uint8_t>(spec.minor));
    put(94, static_cast<std::uint16_t>(header_size));
    put(96, first);
    put(100, records);
    put(104, static_cast<std::uint8_t>(spec.format));
    put(105, static_cast<std::uint16_t>(length));
    const std::uint64_t declared = spec.declared > 0 ? spec.declared : spec.points.size();
    if (spec.minor == 4) {
      put(247, declared);
    } else {
      put(107, static_cast<std::uint32_t>(declared));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(131 + 8 * axis, spec.scale);
      put(155 + 8 * axis, spec.offset[axis]);
    }
  }

  void write(const std::filesystem::path& file) const {
    std::ofstream(file, std::ios::binary).write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
  }

 private:
  template <class Number>
  void put(std::size_t at, Number value) {
    std::memcpy(bytes_.data() + at, &value, sizeof value);
  }
  void add_record(std::uint16_t number, const std::string& data) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + 54 + data.size());
    std::memcpy(bytes_.data() + at + 2, "LASF_Projection", 15);
    put(at + 18, number);
    put(at + 20, static_cast<std::uint16_t>(data.size()));
    std::memcpy(bytes_.data() + at + 54, data.data(), data.size());
  }

  std::vector<char> bytes_;
};

}  // namespace talus::testing_tools
