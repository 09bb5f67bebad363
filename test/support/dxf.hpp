#pragma once
// Small DXF drawings.

#include <algorithm>
#include <initializer_list>
#include <string>

namespace talus::testing_tools {

/// A drawing that declares only its unit ($INSUNITS) and its layers.
struct Drawing {
  std::string header{}, layers{}, blocks{}, entities{};

  Drawing& unit(int number) {
    header += "9\n$INSUNITS\n70\n" + std::to_string(number) + "\n";
    return *this;
  }
  /// `flags`: 1 is frozen. A negative colour means that the layer is switched off.
  Drawing& layer(const std::string& name, int flags, int colour) {
    layers += "0\nLAYER\n2\n" + name + "\n70\n" + std::to_string(flags) + "\n62\n" + std::to_string(colour) + "\n";
    return *this;
  }
  /// `more` are further pairs, for example "67\n1\n" for an entity in paper space.
  Drawing& line(const std::string& on, const std::string& from, const std::string& to, const std::string& more = "") {
    entities += "0\nLINE\n8\n" + on + "\n" + more + place(from, 10) + place(to, 11);
    return *this;
  }
  Drawing& point(const std::string& on, const std::string& at) {
    entities += "0\nPOINT\n8\n" + on + "\n" + place(at, 10);
    return *this;
  }
  /// An LWPOLYLINE, which has only plan coordinates.
  Drawing& polyline(const std::string& on, bool is_closed, std::initializer_list<const char*> corners) {
    entities +=
        "0\nLWPOLYLINE\n8\n" + on + "\n90\n" + std::to_string(corners.size()) + "\n70\n" + (is_closed ? "1\n" : "0\n");
    for (const char* corner : corners) entities += place(corner, 10);
    return *this;
  }
  Drawing& face(const std::string& on, std::initializer_list<const char*> corners) {
    entities += "0\n3DFACE\n8\n" + on + "\n";
    int code = 10;
    for (const char* corner : corners) entities += place(corner, code++);
    return *this;
  }
  /// A curve through two points, which GDAL cannot read.
  Drawing& fitted_spline(const std::string& on, const std::string& from, const std::string& to) {
    entities += "0\nSPLINE\n8\n" + on + "\n70\n8\n71\n3\n72\n0\n73\n0\n74\n2\n" + place(from, 11) + place(to, 11);
    return *this;
  }

  /// A curve of third degree with four control points.
  Drawing& spline(const std::string& on, std::initializer_list<const char*> control, const std::string& more = "") {
    entities += "0\nSPLINE\n8\n" + on + "\n" + more + "70\n8\n71\n3\n72\n8\n73\n4\n74\n0\n";
    for (const char* knot : {"0", "0", "0", "0", "1", "1", "1", "1"}) entities += std::string("40\n") + knot + "\n";
    for (const char* at : control) entities += place(at, 10);
    return *this;
  }
  Drawing& label(const std::string& on, const std::string& at, const std::string& words) {
    entities += "0\nTEXT\n8\n" + on + "\n" + place(at, 10) + "40\n1\n1\n" + words + "\n";
    return *this;
  }
  /// An entity of any kind, of which only the layer is given.
  Drawing& other(const std::string& kind, const std::string& on, const std::string& more = "") {
    entities += "0\n" + kind + "\n8\n" + on + "\n" + more;
    return *this;
  }
  /// A polyline of faces: a polyface mesh of one triangle.
  Drawing& polyface(const std::string& on, std::initializer_list<const char*> corners) {
    entities += "0\nPOLYLINE\n8\n" + on + "\n66\n1\n70\n64\n71\n3\n72\n1\n";
    for (const char* corner : corners) entities += "0\nVERTEX\n8\n" + on + "\n" + place(corner, 10) + "70\n192\n";
    entities += "0\nVERTEX\n8\n" + on + "\n10\n0\n20\n0\n30\n0\n70\n128\n71\n1\n72\n2\n73\n3\n0\nSEQEND\n";
    return *this;
  }
  /// The definition of a block with these entities; an INSERT of it is `other("INSERT", layer, "2\\nNAME\\n")`.
  Drawing& block(const std::string& name, const Drawing& contents) {
    blocks += "0\nBLOCK\n8\n0\n2\n" + name + "\n10\n0\n20\n0\n30\n0\n" + contents.entities + "0\nENDBLK\n8\n0\n";
    return *this;
  }

  [[nodiscard]] std::string text() const {
    return section("HEADER", header) + section("TABLES", "0\nTABLE\n2\nLAYER\n70\n9\n" + layers + "0\nENDTAB\n") +
           (blocks.empty() ? "" : section("BLOCKS", blocks)) + section("ENTITIES", entities) + "0\nEOF\n";
  }

 private:
  static std::string section(const std::string& name, const std::string& text) {
    return "0\nSECTION\n2\n" + name + "\n" + text + "0\nENDSEC\n";
  }
  /// "1 2 3" as the values of x, y and z, whose group codes are ten apart.
  static std::string place(const std::string& numbers, int code) {
    std::string out;
    for (std::size_t at = 0; at < numbers.size(); code += 10) {
      const std::size_t end = std::min(numbers.find(' ', at), numbers.size());
      out += std::to_string(code) + "\n" + numbers.substr(at, end - at) + "\n";
      at = end + 1;
    }
    return out;
  }
};

}  // namespace talus::testing_tools
