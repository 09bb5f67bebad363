#include "talus/barriers/barrier_check.hpp"

#include <cmath>

#include "talus/rocks/heights.hpp"

namespace talus {

std::optional<int> kit_class_of(double maximum_energy) {
  if (maximum_energy > kit_class_energies.back()) return static_cast<int>(kit_class_energies.size());
  const auto next = std::ranges::upper_bound(kit_class_energies, maximum_energy);
  if (next == kit_class_energies.begin()) return std::nullopt;
  return static_cast<int>(next - kit_class_energies.begin()) - 1;
}

namespace {

constexpr double service_share = 3;  // EAD 340059-00-0106: SEL is a third of MEL

/// The first class with this energy, where the first of all is `lowest`.
template <std::size_t count>
int first_class(const std::array<double, count>& energies, int lowest, double energy) {
  return lowest + static_cast<int>(std::ranges::lower_bound(energies, energy) - energies.begin());
}

}  // namespace

int needed_class(const CheckFactors& factors, double maximum_energy) {
  if (factors.level == KitLevel::maximum) return first_class(kit_class_energies, 0, maximum_energy);
  return first_class(kit_class_service_energies, 1, maximum_energy / service_share);
}

double energy_to_check(const CheckFactors& factors, double translational, double total, double velocity) {
  if (factors.block_mass) return 0.5 * *factors.block_mass * velocity * velocity;
  return factors.takes_total_energy ? total : translational;
}

double radius_to_check(const CheckFactors& factors, double mass, double radius) {
  return factors.block_mass ? radius * std::cbrt(*factors.block_mass / mass) : radius;
}

double needed_maximum_energy(const CheckFactors& factors, double energy) {
  const double design = energy * factors.mass * factors.velocity * factors.velocity * factors.energy;
  return design * factors.capacity * (factors.level == KitLevel::service ? service_share : 1);
}

double needed_height(const CheckFactors& factors, double lowest, double radius) {
  if (!factors.clears_half_the_block) return top_over(lowest, radius) * factors.height + factors.clearance;
  return centre_over(lowest, radius) * factors.height + std::max(factors.clearance, radius);
}

std::optional<double> needed_clearance(const CheckFactors& factors, double elongation) {
  if (!factors.elongation) return std::nullopt;
  return elongation * *factors.elongation;
}

std::optional<double> most_elongation(const CheckFactors& factors, double clearance) {
  if (!factors.elongation) return std::nullopt;
  return clearance / *factors.elongation;
}

}  // namespace talus
