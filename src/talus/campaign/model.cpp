#include "talus/campaign/model.hpp"

namespace talus {

Model Model::without_surface() const {
  Model copy;
  copy.varying = varying;
  copy.frame = frame;
  copy.ground = ground;
  copy.barriers = barriers;
  copy.laws = laws;
  copy.seed = seed;
  copy.sampling = sampling;
  copy.seeders = seeders;
  copy.sources = sources;
  copy.energy_datum = energy_datum;
  return copy;
}

}  // namespace talus
