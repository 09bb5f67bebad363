#pragma once
// Parts of answers, as a header Range asks for them. The library would read past the end of an answer.

#include <httplib.h>
#undef _res  // a macro of the resolver's header, and a name in Eigen's

namespace talus::server {

/// Whether a request asks for more than one part.
[[nodiscard]] bool asks_for_several_parts(const httplib::Request& request);

/// Cuts an answer of known size to the part that its request asks for. If that begins beyond the end, the answer
/// becomes a refusal (416).
void apply_range(const httplib::Request& request, httplib::Response& response);

}  // namespace talus::server
