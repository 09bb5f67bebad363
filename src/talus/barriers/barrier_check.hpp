#pragma once
// Requirements on a barrier: the checks of UNI 11211-4, with the energy classes of EAD 340059-00-0106.
//
// UNI 11211-4 ("Rockfall protective measures. Part 4: Definitive and executive design", 2012 and 2018), barriers:
//   v_d = v gamma_F,  gamma_F = gamma_Tr gamma_Dp          design velocity, v the 95th percentile
//   m_d = m gamma_M,  gamma_M = gamma_VolF1 gamma_gamma    design mass
//   E_d = m_d v_d^2 / 2 gamma_R                            design energy
//   E_d <= E_barrier / gamma_E the barrier's energy is its MEL or its SEL
//   H_d = h gamma_F,  H_barrier >= H_d + f                 design height, f the upper clearance
// The standard itself was not available. Formulas and usual factors are quoted from users of it: A. Grimod and G.
// Giacchetti, "Certified deformable rockfall barriers: tests, design and installation", GeoHazards 6 (2014), and
// Rocscience's RocFall, help page "Verification following UNI 11211-4". The factors are therefore inputs. The classes
// are described by D. Peila and C. Ronco, "Design of rockfall net fences and the new ETAG 027 European guideline", Nat.
// Hazards Earth Syst. Sci. 9 (2009) 1291-1298. Left out: the elongation of the net (it must not reach what it
// protects), foundations, several rocks at once.

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

/// The factors of the check; the initial values are neutral.
struct CheckFactors {
  double trajectory = 1;               // gamma_Tr: reliability of the simulation
  double topography = 1;               // gamma_Dp: quality of the survey of the slope
  double volume = 1;                   // gamma_VolF1: accuracy of the block's volume
  double density = 1;                  // gamma_gamma
  double risk = 1;                     // gamma_R: consequences of a failure
  double energy = 1;                   // gamma_E
  double clearance = 0;                // f, the minimum [m]
  bool clears_half_the_block = false;  // f is also at least the block's radius
  bool takes_total_energy = false;     // translational and rotational; if false, only translational
  KitLevel level = KitLevel::maximum;  // the energy of the kit in the check
  std::optional<double> block_mass{};  // of the design block [kg]; nullopt: each rock's own
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

/// The nominal height [m] that a kit needs if a rock of this radius [m] arrives at this height [m].
[[nodiscard]] double needed_height(const CheckFactors& factors, double height, double radius);

}  // namespace talus
