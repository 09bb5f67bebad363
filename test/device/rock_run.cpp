// The run of a rock that tells nobody, as code for a graphics processor: compiled, never run.

#include "talus/trajectory/rock_run.hpp"

template class talus::RockRun<talus::TriangleMesh, talus::event::NoSink>;
template class talus::RockRun<talus::RasterSurface, talus::event::NoSink>;
