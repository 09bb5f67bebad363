#include "talus/export/vtk_paths.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/path_arcs.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/files/output_file.hpp"

namespace talus {

namespace {

using ByteCount = std::uint64_t;  // header_type="UInt64": precedes each array

/// The bytes of one array, collected in memory and written to their place in the file piece by piece.
class Array {
 public:
  /// `attributes` are those of the XML element.
  Array(std::string attributes, ByteCount bytes) : attributes_(std::move(attributes)), bytes_(bytes) {}

  /// Its XML element; `offset` of its bytes is counted from the mark _ on.
  [[nodiscard]] std::string element(ByteCount offset) const {
    return fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>", attributes_, offset);
  }
  [[nodiscard]] ByteCount bytes_with_count() const { return sizeof(ByteCount) + bytes_; }
  void begin(ByteCount position) {
    position_ = position;
    put(bytes_);
  }
  template <class Number>
  void put(Number number) {
    waiting_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void write_if_much(OutputFile& file) {
    constexpr std::size_t much = std::size_t{1} << 18U;
    if (waiting_.size() >= much) write(file);
  }
  void write(OutputFile& file) {
    file.seek(position_);
    file.write(waiting_);
    position_ += waiting_.size();
    waiting_.clear();
  }

 private:
  std::string attributes_, waiting_;
  ByteCount bytes_, position_ = 0;
};

struct Counts {
  std::uint64_t points = 0, lines = 0;
};

bool every_rock(std::uint64_t) { return true; }

Counts count(const std::filesystem::path& paths) {
  Counts counts;
  for (PathReader reader(paths); reader.next(every_rock); ++counts.lines) {
    for_points_along(reader.path(), vtk_tolerance_m, [&](const PathPoint&) { ++counts.points; });
  }
  return counts;
}

/// All arrays, in the order of their bytes in the file.
struct Arrays {
  explicit Arrays(const Counts& counts)
      : time(R"(type="Float64" Name="time_s")", counts.points * sizeof(double)),
        velocity(R"(type="Float32" Name="velocity_m_s" NumberOfComponents="3")", counts.points * 3 * sizeof(float)),
        energy(R"(type="Float64" Name="ke_total_J")", counts.points * sizeof(double)),
        state(R"(type="UInt8" Name="state")", counts.points),
        rock(R"(type="Int64" Name="rock")", counts.lines * sizeof(std::int64_t)),
        place(R"(type="Float64" Name="Points" NumberOfComponents="3")", counts.points * 3 * sizeof(double)),
        connectivity(R"(type="Int64" Name="connectivity")", counts.points * sizeof(std::int64_t)),
        offsets(R"(type="Int64" Name="offsets")", counts.lines * sizeof(std::int64_t)) {}
  Array time, velocity, energy, state, rock, place, connectivity, offsets;

  [[nodiscard]] std::vector<Array*> all() {
    return {&time, &velocity, &energy, &state, &rock, &place, &connectivity, &offsets};
  }
};

std::string head(const Counts& counts, Arrays& arrays) {
  std::vector<std::string> elements;
  ByteCount offset = 0;
  for (const Array* array : arrays.all()) {
    elements.push_back(array->element(offset));
    offset += array->bytes_with_count();
  }
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">"
      "\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", counts.points, counts.lines);
  out += fmt::format(
      "<PointData Scalars=\"ke_total_J\" Vectors=\"velocity_m_s\">\n{}\n{}\n{}\n{}\n</PointData>\n"
      "<CellData Scalars=\"rock\">\n{}\n</CellData>\n"
      "<Points>\n{}\n</Points>\n"
      "<Lines>\n{}\n{}\n</Lines>\n"
      "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
      elements[0], elements[1], elements[2], elements[3], elements[4], elements[5], elements[6], elements[7]);
  return out;
}

}  // namespace

void write_vtk_paths(const std::filesystem::path& folder) {
  const std::filesystem::path paths = folder / PathEventRow::file_name;
  const Counts counts = count(paths);
  Arrays arrays(counts);
  OutputFile file(folder / vtk_paths_name);
  const std::string before = head(counts, arrays);
  file.write(before);
  ByteCount position = before.size();
  for (Array* array : arrays.all()) {
    array->begin(position);
    position += array->bytes_with_count();
  }

  std::int64_t points = 0;
  for (PathReader reader(paths); reader.next(every_rock);) {
    for_points_along(reader.path(), vtk_tolerance_m, [&](const PathPoint& point) {
      arrays.time.put(point.time_s);
      for (const double v : point.velocity_m_s) arrays.velocity.put(static_cast<float>(v));
      arrays.energy.put(point.ke_total_J);
      arrays.state.put(static_cast<std::uint8_t>(point.state));
      for (const double x : point.position_m) arrays.place.put(x);
      arrays.connectivity.put(points++);
    });
    arrays.rock.put(static_cast<std::int64_t>(reader.path().rock));
    arrays.offsets.put(points);
    for (Array* array : arrays.all()) array->write_if_much(file);
  }
  for (Array* array : arrays.all()) array->write(file);
  file.seek(position);
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

}  // namespace talus
