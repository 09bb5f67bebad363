#include "talus/barriers/barrier_check.hpp"

namespace talus {

std::optional<int> kit_class_of(double maximum_energy) {
  if (maximum_energy > kit_class_energies.back()) return static_cast<int>(kit_class_energies.size());
  const auto next = std::ranges::upper_bound(kit_class_energies, maximum_energy);
  if (next == kit_class_energies.begin()) return std::nullopt;
  return static_cast<int>(next - kit_class_energies.begin()) - 1;
}

int needed_class(const CheckFactors& factors, double maximum_energy) {
  if (factors.level == KitLevel::service) maximum_energy = std::max(maximum_energy, least_energy_with_service);
  return static_cast<int>(std::ranges::lower_bound(kit_class_energies, maximum_energy) - kit_class_energies.begin());
}

double energy_to_check(const CheckFactors& factors, double translational, double total, double velocity) {
  if (factors.block_mass) return 0.5 * *factors.block_mass * velocity * velocity;
  return factors.takes_total_energy ? total : translational;
}

double needed_maximum_energy(const CheckFactors& factors, double energy) {
  const double of_velocity = factors.trajectory * factors.topography;
  const double design = energy * factors.volume * factors.density * of_velocity * of_velocity * factors.risk;
  constexpr double service_share = 3;  // EAD 340059-00-0106: SEL is a third of MEL
  return design * factors.energy * (factors.level == KitLevel::service ? service_share : 1);
}

double needed_height(const CheckFactors& factors, double height, double radius) {
  const double clearance = factors.clears_half_the_block ? std::max(factors.clearance, radius) : factors.clearance;
  return height * factors.trajectory * factors.topography + clearance;
}

}  // namespace talus
