#include "talus/trajectory/rock_path.hpp"

#include <variant>

#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus {

template <class Surface>
RockOutcome follow_rock(const Scene<Surface>& scene, const Release& release, const Draws& draws, RockLog& log) {
  log.clear();
  return RockRun<Surface>(scene, release, draws, log).follow();
}

template class RockRun<Profile>;
template class RockRun<TriangleMesh>;
template class RockRun<RasterSurface>;

template RockOutcome follow_rock(const Scene<Profile>&, const Release&, const Draws&, RockLog&);
template RockOutcome follow_rock(const Scene<TriangleMesh>&, const Release&, const Draws&, RockLog&);
template RockOutcome follow_rock(const Scene<RasterSurface>&, const Release&, const Draws&, RockLog&);

}  // namespace talus
