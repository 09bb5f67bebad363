// What bench/build.py compares the time of a build with: headers and templates of the kinds that the source has.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <string>
#include <variant>
#include <vector>

double solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.ldlt().solve(b).norm(); }

std::vector<std::string> visited(const std::vector<std::variant<int, double, std::string>>& values) {
  std::vector<std::string> texts;
  for (const auto& value : values)
    texts.push_back(std::visit([](const auto& each) { return fmt::format("{}", each); }, value));
  return texts;
}
