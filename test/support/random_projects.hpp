#pragma once
// Small projects with random settings, as text: every model, sections and meshes near and far from the origin, barriers
// that lean or give way, seeders on the ground and above it, also next to barriers.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "support/dice.hpp"

namespace talus::testing_tools {

class RandomProject {
 public:
  explicit RandomProject(std::uint64_t seed) : dice_(seed) {
    is_2d_ = dice_.chance(0.5);
    is_sphere_ = dice_.chance(0.5);
    size_ = dice_.chance(0.1) ? dice_.magnitude(0.05, 2) : dice_.magnitude(10, 300);
    if (dice_.chance(0.3)) origin_x_ = 600'000, origin_y_ = is_2d_ ? 0 : 5'200'000;
    add_analysis();
    is_2d_ ? add_section() : add_mesh();
    add_materials();
    for (std::size_t k = 1 + dice_.below(3); k > 0; --k) add_seeder();
    for (std::size_t k = dice_.below(4); k > 0; --k) add_barrier();
    text_ +=
        fmt::format("[output]\npaths = \"all\"\nreport = false\ngeopackage = \"none\"\nmaps = {}\nraster_cell_m = {}\n",
                    is_2d_ || dice_.chance(0.5), std::max(0.01, size_ / dice_.between(3, 60)));
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool is_2d() const { return is_2d_; }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> line, Values&&... values) {
    text_ += fmt::format(line, std::forward<Values>(values)...) + '\n';
  }
  std::string word(std::initializer_list<const char*> words) {
    return fmt::format("\"{}\"", words.begin()[dice_.below(words.size())]);
  }

  /// A number, or a distribution about it; within 0 and `most`.
  std::string random_value(double mean, double most) {
    if (dice_.chance(0.6)) return fmt::format("{}", mean);
    const char* const kind = std::vector<const char*>{"normal",      "uniform",   "triangular", "beta",
                                                      "exponential", "lognormal", "gamma"}[dice_.below(7)];
    const double low = mean * dice_.between(0.05, 0.9), high = (most - mean) * dice_.between(0.05, 0.9);
    return fmt::format("{{ mean = {}, distribution = \"{}\", std_dev = {}, rel_min = {}, rel_max = {} }}", mean, kind,
                       0.3 * std::min(low, high), low, high);
  }

  void add_analysis() {
    add("[analysis]\nmodel = \"{}\"\nmax_steps = 3000\nmax_time_s = 200", is_sphere_ ? "rigid_sphere" : "lumped_mass");
    if (!is_sphere_) {
      add("rotation = {}\nsliding = {}\nfriction_angle = {}", dice_.chance(0.5), word({"stepped", "closed_form"}),
          word({"material", "material", "tangential_restitution"}));
    } else {
      add("rolling_resistance_in_impacts = {}\ntangential_crsp_damping = {}", dice_.chance(0.7), dice_.chance(0.2));
    }
    add("grazing_angle_deg = {}", dice_.chance(0.3) ? 0 : dice_.between(0, 30));
    add("scale_rn_by_velocity = {}", dice_.chance(0.3));
    if (dice_.chance(0.3)) add("normal_velocity_cutoff_m_s = {}", dice_.chance(0.3) ? 0 : dice_.magnitude(1e-9, 1));
    if (dice_.chance(0.2)) add("max_timestep_s = {}", dice_.magnitude(1e-3, 1e6));
    if (dice_.chance(0.2)) add("gravity_m_s2 = {}", dice_.magnitude(0.1, 100));
    add("[sampling]\nseed = {}\nmethod = {}\nmaterials = {}", dice_.below(1000),
        word({"monte_carlo", "latin_hypercube"}), word({"per_impact", "per_rock"}));
  }

  void add_section() {
    text_ += "[terrain]\nsection = [";
    const std::size_t count = 2 + dice_.below(9);
    double z = size_;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = size_ * static_cast<double>(k) / static_cast<double>(count - 1);
      text_ += fmt::format("[{}, {}], ", origin_x_ + x, z);
      z -= size_ / static_cast<double>(count) * dice_.between(-0.4, 2);
    }
    text_ += "]\n";
  }
  void add_mesh() {
    const std::size_t n = 3 + dice_.below(6);
    const double cell = size_ / static_cast<double>(n - 1), fall = dice_.between(0, 1.5);
    const double rough = dice_.chance(0.2) ? 0 : dice_.magnitude(0.01, 0.8);
    text_ += "[terrain]\nvertices = [";
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        const double x = cell * static_cast<double>(i), y = cell * static_cast<double>(j);
        text_ += fmt::format("[{}, {}, {}], ", origin_x_ + x, origin_y_ + y,
                             1000 - fall * x + rough * cell * dice_.between(-1, 1));
      }
    }
    text_ += "]\ntriangles = [";
    for (std::size_t j = 0; j + 1 < n; ++j) {
      for (std::size_t i = 0; i + 1 < n; ++i) {
        const std::size_t a = j * n + i, b = a + 1, c = a + n, d = c + 1;
        text_ += dice_.chance(0.5) ? fmt::format("[{}, {}, {}], [{}, {}, {}], ", a, b, d, a, d, c)
                                   : fmt::format("[{}, {}, {}], [{}, {}, {}], ", a, b, c, b, d, c);
      }
    }
    text_ += "]\n";
  }

  void add_materials() {
    const std::size_t count = 1 + dice_.below(2);
    for (std::size_t k = 0; k < count; ++k) {
      add("[[material]]\nname = \"M{}\"", k);
      add("normal_restitution = {}", random_value(dice_.between(0.05, 0.8), 1));
      add("tangential_restitution = {}", random_value(dice_.between(0.1, 0.95), 1));
      if (dice_.chance(0.4)) add("roughness_deg = {}", dice_.between(0, 20));
      if (!is_sphere_) add("friction_angle_deg = {}", random_value(dice_.between(5, 50), 89));
      if (is_sphere_) {
        add("dynamic_friction = {}", random_value(dice_.between(0.05, 1), 2));
        add("rolling_friction = {}", random_value(dice_.between(0.02, 0.8), 2));
      }
      if (dice_.chance(0.1)) add("ground_drag_per_s = {}", dice_.magnitude(0.01, 10));
      if (dice_.chance(0.1))
        add("forest_drag_kg_s = {}\nforest_height_m = {}", dice_.magnitude(10, 1e5), dice_.between(1, 20));
    }
    add("[ground]\ndefault = \"M0\"");
    if (!is_2d_ && dice_.chance(0.1)) add_forest();
  }
  void add_forest() {
    const double x = origin_x_ + inside(), y = origin_y_ + inside(), across = size_ * dice_.between(0.1, 1);
    add("[[forest]]\ndrag_kg_s = {}\nheight_m = {}", dice_.magnitude(10, 1e5), dice_.between(1, 20));
    add("polygon = [[{0}, {1}], [{2}, {1}], [{2}, {3}]]", x, y, x + across, y + across);
  }

  /// A place on plan, well inside.
  double inside() { return size_ * dice_.between(0.05, 0.9); }
  std::string place() {
    near_ = inside();
    return is_2d_ ? fmt::format("[{}]", origin_x_ + near_)
                  : fmt::format("[{}, {}]", origin_x_ + near_, origin_y_ + inside());
  }
  void add_seeder() {
    add("[[seeder]]");
    if (dice_.chance(0.5)) {
      add("type = \"line\"\npoints = [{}, {}]", place(), place());
    } else {
      add("position = {}", place());
    }
    diameter_ = size_ * dice_.magnitude(1e-3, 0.1);
    add("height_above_m = {}\nrocks = {}", dice_.chance(0.5) ? 0 : size_ * dice_.magnitude(1e-3, 0.5),
        2 + dice_.below(8));
    add("diameter_m = {}", diameter_);
    if (dice_.chance(0.6)) add("horizontal_velocity_m_s = {}", dice_.between(-5, 15));
    if (dice_.chance(0.3)) add("vertical_velocity_m_s = {}", dice_.between(-10, 10));
    if (dice_.chance(0.4)) add("rotational_velocity_deg_s = {}", dice_.between(-3000, 3000));
  }

  void add_barrier() {
    const bool is_collector = dice_.chance(0.3);
    add("[[{}]]", is_collector ? "collector" : "barrier");
    // Often so near to a seeder that its rocks begin within the barrier.
    const double x = origin_x_ + (dice_.chance(0.4) ? near_ + diameter_ * dice_.between(-1, 1) : inside());
    if (is_2d_) {
      add("line = {}", x);
    } else {
      add("line = [[{}, {}], [{}, {}], [{}, {}]]", x, origin_y_ + size_ * dice_.between(0.01, 0.3),
          x + size_ * dice_.between(-0.04, 0.04), origin_y_ + size_ * dice_.between(0.4, 0.6), x,
          origin_y_ + size_ * dice_.between(0.7, 0.99));
    }
    add("height_m = {}", size_ * dice_.magnitude(0.005, 0.3));
    if (dice_.chance(0.4)) add("inclination_deg = {}", dice_.between(-60, 60));
    if (is_collector) return;
    if (dice_.chance(0.4)) add("capacity_kJ = {}", dice_.magnitude(1e-3, 1e6));
    if (dice_.chance(0.5)) add("normal_restitution = {}\ntangential_restitution = {}", dice_.unit(), dice_.unit());
  }

  Dice dice_;
  bool is_2d_ = false, is_sphere_ = false;
  double size_ = 0, origin_x_ = 0, origin_y_ = 0;  // [m]
  double near_ = 0, diameter_ = 0;                 // place along x, and size of the rocks, of the last seeder [m]
  std::string text_;
};

}  // namespace talus::testing_tools
