#pragma once
// Requirements on a barrier: one form of check, whose factors are data (project/standards/), with the energy classes of
// EAD 340059-00-0106. Symbols, sources and what could not be read of them: docs/barrier-design.md. With the percentiles
// v, h of velocity and height, and k_... the products of the factors on each quantity:
//   E_d = m k_m (v k_v)^2 / 2 k_e     design energy; without a design block m v^2 / 2 is the percentile of the energies
//   E_d <= E_kit / k_c                the kit's energy is its MEL or its SEL
//   H_d = h k_h,  H_kit >= H_d + f    design height, f the upper clearance; h is the height of the block's centre where
//                                     f holds its upper half, else of its top: the block is never counted twice
//   D_d = D_kit k_d,  D_A >= D_d      design elongation against the distance to what is protected
// UNI 11211-4: k_v = k_h = gamma_Tr gamma_Dp, k_m = gamma_VolF1 gamma_gamma, k_e = gamma_R, k_c = gamma_E. ONR 24810
// has k_e and k_h apart. The classes are described by D. Peila and C. Ronco, "Design of rockfall net fences and the new
// ETAG 027 European guideline", Nat. Hazards Earth Syst. Sci. 9 (2009) 1291-1298. Left out: foundations, several rocks
// at once.

#include <algorithm>
#include <array>
#include <optional>

namespace talus {

/// The energy that a kit is designed for: the maximum energy level, MEL, of which it stops one impact; or the service
/// energy level, SEL, a third of the MEL, of which it stops two impacts without repair.
enum class KitLevel { maximum, service };

/// MEL of the energy classes 0 to 7 [J]; class 8 contains all kits above. EAD 340059-00-0106 (formerly ETAG 027).
inline constexpr std::array<double, 8> kit_class_energies{100e3, 250e3, 500e3, 1000e3, 1500e3, 2000e3, 3000e3, 4500e3};
/// The class of a kit with this MEL [J]; nullopt below class 0.
[[nodiscard]] std::optional<int> kit_class_of(double maximum_energy);
/// Kits of class 0 have no SEL.
inline constexpr double least_energy_with_service = kit_class_energies[1];
/// SEL of the classes 1 to 7 [J]: a third of their MEL, rounded.
inline constexpr std::array<double, 7> kit_class_service_energies{85e3, 170e3, 330e3, 500e3, 660e3, 1000e3, 1500e3};

/// The factors of the check, each the product of those of a set; the initial values are neutral.
struct CheckFactors {
  double velocity = 1;                   // on velocities; on energies with its square
  double height = 1;                     // on heights
  double mass = 1;                       // on masses, and so on energies
  double energy = 1;                     // on energies alone
  double capacity = 1;                   // divides the energy of the kit
  double clearance = 0;                  // f, the minimum [m]
  std::optional<double> elongation = 1;  // on the elongation of the kit; nullopt: unknown
  bool clears_half_the_block = false;    // f is from the block's centre, at least its radius; if false, from its top
  bool takes_total_energy = false;       // translational and rotational; if false, only translational
  KitLevel level = KitLevel::maximum;    // the energy of the kit in the check
  std::optional<double> block_mass{};    // of the design block [kg]; nullopt: each rock's own
  friend bool operator==(const CheckFactors&, const CheckFactors&) = default;
};

/// The energy that the check starts from [J]: of the design block, if there is one, at this velocity [m/s].
[[nodiscard]] double energy_to_check(const CheckFactors& factors, double translational, double total, double velocity);

/// The radius [m] for the upper clearance: of the design block, if there is one, with this rock's density.
[[nodiscard]] double radius_to_check(const CheckFactors& factors, double mass, double radius);

/// The MEL [J] that a kit needs for a rock, or a percentile of rocks, with this energy [J].
[[nodiscard]] double needed_maximum_energy(const CheckFactors& factors, double energy);

/// The lowest class whose kits all have this MEL [J] or, if the check is of the SEL, a SEL of a third of it.
[[nodiscard]] int needed_class(const CheckFactors& factors, double maximum_energy);

/// D_d, the distance [m] on plan that must be free behind a kit with this elongation [m]; nullopt if the factor on it
/// is unknown.
[[nodiscard]] std::optional<double> needed_clearance(const CheckFactors& factors, double elongation);

/// The largest elongation [m] that a kit may have in its test where this distance [m] on plan is free.
[[nodiscard]] std::optional<double> most_elongation(const CheckFactors& factors, double clearance);

/// The nominal height [m] that a kit needs for a rock of this radius [m] whose lowest point arrives at this height [m]
/// above the foot: with neutral factors that of its top.
[[nodiscard]] double needed_height(const CheckFactors& factors, double lowest, double radius);

}  // namespace talus
