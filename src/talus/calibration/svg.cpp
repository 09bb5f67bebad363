#include "talus/calibration/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::calibration {

namespace {

constexpr int left = 56, right = 12, top = 10, bottom = 40;  // margins

void widen(Plot::Axis& axis) {
  if (axis.most > axis.least) return;
  const double half = std::max(std::abs(axis.least) * 0.05, 0.5);
  axis.least -= half;
  axis.most += half;
}

/// Round numbers within the axis, about five.
std::vector<double> ticks(const Plot::Axis& axis) {
  const double rough = (axis.most - axis.least) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double factor = rough / power;
  const double step = power * (factor > 5 ? 10 : factor > 2 ? 5 : factor > 1 ? 2 : 1);
  std::vector<double> ticks;
  for (double at = std::ceil(axis.least / step) * step; at <= axis.most + 1e-9 * step; at += step) {
    ticks.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
  }
  return ticks;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

Plot::Plot(int width, int height, Axis x, Axis y) : width_(width), height_(height), x_(std::move(x)), y_(std::move(y)) {
  widen(x_);
  widen(y_);
}

double Plot::px(double x) const {
  const double share = std::clamp((x - x_.least) / (x_.most - x_.least), 0.0, 1.0);
  return left + share * (width_ - left - right);
}

double Plot::py(double y) const {
  const double share = std::clamp((y - y_.least) / (y_.most - y_.least), 0.0, 1.0);
  return height_ - bottom - share * (height_ - top - bottom);
}

void Plot::line(const std::vector<std::pair<double, double>>& points, std::string_view style) {
  marks_ += "<polyline points=\"";
  for (const auto& [x, y] : points) marks_ += fmt::format("{:.1f},{:.1f} ", px(x), py(y));
  marks_ += fmt::format("\" class=\"{}\"/>", style);
}

void Plot::band(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high,
                std::string_view style) {
  marks_ += "<polygon points=\"";
  for (std::size_t k = 0; k < x.size(); ++k) marks_ += fmt::format("{:.1f},{:.1f} ", px(x[k]), py(high[k]));
  for (std::size_t k = x.size(); k-- > 0;) marks_ += fmt::format("{:.1f},{:.1f} ", px(x[k]), py(low[k]));
  marks_ += fmt::format("\" class=\"{}\"/>", style);
}

void Plot::bar(double from, double to, double height, std::string_view style) {
  marks_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"{}\"/>", px(from),
                        py(height), std::max(px(to) - px(from) - 1, 0.5), py(y_.least) - py(height), style);
}

void Plot::dot(double x, double y, double radius, std::string_view style) {
  marks_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"{}\"/>", px(x), py(y), radius, style);
}

void Plot::vertical(double x, std::string_view style) {
  marks_ += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" class=\"{3}\"/>", px(x), top,
                        height_ - bottom, style);
}

std::string Plot::text() const {
  std::string out =
      fmt::format("<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">", width_, height_);
  for (const double at : ticks(x_)) {
    out += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" class=\"grid\"/>"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>",
        px(at), top, height_ - bottom, height_ - bottom + 15, at);
  }
  for (const double at : ticks(y_)) {
    out += fmt::format(
        "<line x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" class=\"grid\"/>"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>",
        py(at), left, width_ - right, left - 5, py(at) + 4, at);
  }
  out += marks_;
  out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" class=\"title\">{}</text>",
                     left + (width_ - left - right) / 2, height_ - 6, escaped(x_.title));
  out +=
      fmt::format("<text transform=\"translate(12 {}) rotate(-90)\" text-anchor=\"middle\" class=\"title\">{}</text>",
                  top + (height_ - top - bottom) / 2, escaped(y_.title));
  return out + "</svg>\n";
}

}  // namespace talus::calibration
