#include "talus/files/mesh_problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/core/utf8.hpp"

namespace talus {

Problem MeshProblems::problem(const MeshPlace& place, std::string what, std::string why, std::string hint) const {
  Problem out;
  out.file = file_;
  out.line = static_cast<int>(std::min<std::uint32_t>(place.line, std::numeric_limits<int>::max()));
  out.where = place.where;
  out.what = std::move(what);
  out.why = std::move(why);
  out.hint = std::move(hint);
  return out;
}

void MeshProblems::refuse(const MeshPlace& place, std::string what, std::string why, std::string hint) {
  errors_.add(problem(place, std::move(what), std::move(why), std::move(hint)));
  if (errors_.list().size() == most_errors) {
    stop({}, "reading stopped", fmt::format("{} errors were found so far", most_errors));
  }
}

void MeshProblems::stop(const MeshPlace& place, std::string what, std::string why, std::string hint) {
  errors_.add(problem(place, std::move(what), std::move(why), std::move(hint)));
  throw BadInput(errors_);
}

void MeshProblems::warn(const MeshPlace& place, std::string what, std::string why, std::string hint) {
  Problem warning = problem(place, std::move(what), std::move(why), std::move(hint));
  warning.severity = Severity::warning;
  warnings_.add(std::move(warning));
}

void MeshProblems::throw_if_any() const {
  if (errors_.has_errors()) throw BadInput(errors_);
}

void warn_of_single_precision(float largest, MeshProblems& problems) {
  const double spacing_m = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
  if (spacing_m <= 0.001) return;
  problems.warn({}, "coordinates are stored in single precision",
                fmt::format("near {:.0f} m such numbers are {:.2g} m apart", largest, spacing_m),
                "Write the file in double precision, or subtract an offset before writing it");
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  return '"' + for_message(text, longest) + '"';
}

}  // namespace talus
