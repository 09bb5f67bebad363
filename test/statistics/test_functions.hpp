#pragma once
// Functions of the unit hypercube whose indices are known in closed form.

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace talus::testing_tools {

/// T. Ishigami and T. Homma, "An importance quantification technique in uncertainty analysis for computer models",
/// ISUMA (1990): sin x1 + a sin^2 x2 + b x3^4 sin x1, each x uniform from -pi to pi.
struct Ishigami {
  double a = 7, b = 0.1;

  [[nodiscard]] double operator()(const std::vector<double>& u) const {
    const auto x = [&](std::size_t i) { return (2 * u[i] - 1) * std::numbers::pi; };
    return std::sin(x(0)) + a * std::pow(std::sin(x(1)), 2) + b * std::pow(x(2), 4) * std::sin(x(0));
  }
  // E sin^2 = 1/2, E x^4 = pi^4/5, E x^8 = pi^8/9, Var sin^2 = 1/8: so
  // E(f | x1) = (1 + b pi^4/5) sin x1 + a/2, E(f | x2) = a sin^2 x2, E(f | x3) = a/2.
  [[nodiscard]] double of_first() const { return std::pow(1 + b * std::pow(std::numbers::pi, 4) / 5, 2) / 2; }
  [[nodiscard]] double of_second() const { return a * a / 8; }
  // What is left is E Var(b x3^4 sin x1 | x1).
  [[nodiscard]] double of_first_and_third() const {
    return b * b * std::pow(std::numbers::pi, 8) * (1.0 / 9 - 1.0 / 25) / 2;
  }
  [[nodiscard]] double variance() const { return of_first() + of_second() + of_first_and_third(); }
  [[nodiscard]] std::vector<double> first() const { return {of_first() / variance(), of_second() / variance(), 0}; }
  [[nodiscard]] std::vector<double> total() const {
    return {(of_first() + of_first_and_third()) / variance(), of_second() / variance(),
            of_first_and_third() / variance()};
  }
};

/// Sobol's g-function, the product of (|4 u_i - 2| + a_i)/(1 + a_i), each factor with mean 1 and variance
/// 1/(3 (1 + a_i)^2): I. M. Sobol', Mathematics and Computers in Simulation 55 (2001) 271-280.
struct SobolG {
  std::vector<double> a{0, 1, 4.5, 9, 99, 99, 99, 99};

  [[nodiscard]] double operator()(const std::vector<double>& u) const {
    double product = 1;
    for (std::size_t i = 0; i < a.size(); ++i) product *= (std::abs(4 * u[i] - 2) + a[i]) / (1 + a[i]);
    return product;
  }
  [[nodiscard]] double of(std::size_t i) const { return 1 / (3 * (1 + a[i]) * (1 + a[i])); }
  [[nodiscard]] double variance() const { return product_without(a.size()) - 1; }
  [[nodiscard]] double first(std::size_t i) const { return of(i) / variance(); }
  [[nodiscard]] double total(std::size_t i) const { return of(i) * product_without(i) / variance(); }

 private:
  [[nodiscard]] double product_without(std::size_t left_out) const {
    double product = 1;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (i != left_out) product *= 1 + of(i);
    return product;
  }
};

template <class Function>
std::vector<std::optional<double>> results_of(const std::vector<std::vector<double>>& points, const Function& f) {
  std::vector<std::optional<double>> results;
  for (const std::vector<double>& point : points) results.emplace_back(f(point));
  return results;
}

}  // namespace talus::testing_tools
