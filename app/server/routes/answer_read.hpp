#pragma once
// Answers from files that the user names.

#include <functional>

#include "http/router.hpp"
#include "model_reading.hpp"
#include "run_model.hpp"
#include "talus/archive/model_json.hpp"
#include "workplace.hpp"

namespace talus::server {

/// Reads in a thread of its own, since the files may be on a drive that does not respond. Problems name files as seen
/// from the folder.
[[nodiscard]] inline Answer answer_read(ModelReading& reading, const Workplace& workplace,
                                        const std::function<Json()>& read) {
  try {
    return json_answer(*reading.read<Json>("", read));
  } catch (const BadInput& bad) {
    throw BadInput(seen_from(workplace.folder(), bad.problems()));
  }
}

}  // namespace talus::server
