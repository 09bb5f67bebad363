#pragma once
// Plots of the calibration's report as SVG text: axes with round numbers, and marks in the units of the data.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::calibration {

/// A text in HTML or SVG.
[[nodiscard]] std::string escaped(std::string_view text);

class Plot {
 public:
  struct Axis {
    double least = 0, most = 1;
    std::string title;
  };
  /// Axes of no length are widened.
  Plot(int width, int height, Axis x, Axis y);

  void line(const std::vector<std::pair<double, double>>& points, std::string_view style);
  /// The area between two lines with the same x.
  void band(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high,
            std::string_view style);
  /// From the bottom of the plot.
  void bar(double from, double to, double height, std::string_view style);
  void dot(double x, double y, double radius, std::string_view style);
  void vertical(double x, std::string_view style);

  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] double px(double x) const;
  [[nodiscard]] double py(double y) const;

  int width_, height_;
  Axis x_, y_;
  std::string marks_;
};

}  // namespace talus::calibration
