#include <algorithm>
#include <array>

#include "assets.hpp"
#include "routes/routes.hpp"
#include "talus/files/output_file.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

struct Example {
  std::string_view id, title, what, file;
};

// The bundled examples that the start page shows, in this order.
constexpr std::array examples{
    Example{"tutorial-1-2d", "Tutorial 1, a section", "Fifty rocks down a slope of five segments, in 2D",
            "tutorial-1/tutorial-1-2d.toml"},
    Example{"tutorial-1-3d", "Tutorial 1, in 3D", "The same slope extruded 50 m along the road, with a collector",
            "tutorial-1/tutorial-1-3d.toml"},
    Example{"blocks", "Blocks", "Long, flat and equant blocks, and spheres, from the same cliff: where each stops",
            "blocks/blocks.toml"},
    Example{"bowl", "The bowl", "Three closed polylines become a surface; one rock, whose trajectory is published",
            "bowl/bowl.toml"},
    Example{"sliding", "Sliding", "Rocks bounce, slide uphill, turn back and come to rest", "sliding/sliding.toml"},
    Example{"barrier", "A barrier", "A hundred rocks and a barrier: how many hit it, how high, and with what energy",
            "barrier/barrier.toml"},
    Example{"first-gis-run", "Cliffs from a GIS", "A valley from a GeoTIFF, rocks from polygons of cliffs, and maps",
            "first-gis-run/first-gis-run.toml"},
    Example{"maungawhau", "Maungawhau", "A real volcano on a 10 m grid: rocks from the crater rim, and maps",
            "maungawhau/maungawhau.toml"},
    Example{"boulders", "Boulders",
            "Boulders tumble from the rim of the same volcano: each has its own shape, drawn as it turns",
            "maungawhau/boulders.toml"},
    Example{"barrier-design", "A barrier, designed",
            "The same volcano with possible lines of barriers, and the energy and height that they need",
            "maungawhau/barrier-design.toml"},
    Example{"crater", "A crater",
            "Rigid spheres roll from the rim of the same volcano into its crater and come to rest",
            "maungawhau/crater.toml"}};

}  // namespace

void add_example_routes(Router& router, const Workplace& workplace) {
  router.get("/api/examples", [](const Call&) {
    Json list = Json::array();
    for (const Example& example : examples)
      list.push_back({{"id", example.id}, {"title", example.title}, {"what", example.what}, {"file", example.file}});
    return json_answer({{"examples", list}});
  });
  router.post(R"(/api/examples/([a-z0-9-]+))", [&workplace](const Call& call) {
    call.only({});
    const auto example =
        std::find_if(examples.begin(), examples.end(), [&](const Example& known) { return known.id == call.part(1); });
    if (example == examples.end()) throw Refusal(404, call.part(1), "there is no such example");
    const std::string_view folder = example->file.substr(0, example->file.find('/') + 1);
    for (const ExampleFile& file : example_files()) {
      if (!file.path.starts_with(folder)) continue;
      const fs::path path = workplace.at(file.path);
      std::error_code ignored;
      if (fs::exists(path, ignored)) continue;
      fs::create_directories(path.parent_path(), ignored);
      OutputFile output(path);
      output.write(file.bytes);
      output.commit();
    }
    return json_answer({{"project", example->file}});
  });
}

}  // namespace talus::server
