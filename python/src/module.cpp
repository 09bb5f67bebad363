#include "away.hpp"
#include "bindings.hpp"
#include "talus/gdal/gdal_start.hpp"

PYBIND11_MODULE(_talus, module) {
  using namespace talus::python;
  module.doc() = "The engine of Talus. Use the package talus, which is made of it.";
  module.attr("__version__") = TALUS_VERSION;
#ifdef TALUS_HAS_GDAL
  talus::share_gdal();  // with rasterio, geopandas and others
#endif
  watch_process();
  bind_problems(module);
  bind_project(module);
  bind_results(module);
  bind_model(module);
  bind_follow(module);
  bind_surface(module);
  bind_kernel(module);
  bind_asked(module);
  bind_what_if(module);
  bind_studies(module);
}
