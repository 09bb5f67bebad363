#include "routes/routes.hpp"
#include "run_store.hpp"

namespace talus::server {

void add_calibration_routes(Router& router, RunStore& runs) {
  router.post("/api/calibrations", [&runs](const Call& call) {
    call.only({"file", "text", "replace"});
    const auto replace = call.body.find("replace");
    if (replace != call.body.end() && !replace->is_boolean())
      throw Refusal(400, "replace", "has the wrong type", "expected true or false");
    const Run run = runs.begin(CalibrationOrder{.file = call.text("file"),
                                                .text = call.text("text"),
                                                .replace = replace != call.body.end() && replace->get<bool>()});
    return json_answer(runs.json_of(run), 202);
  });
}

}  // namespace talus::server
