#include <mutex>

#include "routes/routes.hpp"
#include "talus/verification/cases.hpp"
#include "talus/verification/show.hpp"
#include "talus/verification/verify.hpp"

namespace talus::server {

namespace {

Json verification_json() {
  using namespace verification;
  const Files files = embedded_cases();
  std::vector<CaseResult> results;
  for (const std::string& name : case_names(files)) results.push_back(verify(read_case(files, name), files));
  Json shown = json(results);
  for (std::size_t k = 0; k < results.size(); ++k) {
    Json& one = shown["cases"][k];
    const std::size_t agree = results[k].count(Verdict::agrees);
    one["agree"] = agree;
    one["compared"] = agree + results[k].count(Verdict::differs);
  }
  return shown;
}

}  // namespace

void add_verification_routes(Router& router) {
  router.get("/api/verification", [](const Call&) {
    // The results depend on the program alone: they are computed once, while concurrent requests wait.
    static std::mutex running;
    static Json known;
    const std::lock_guard lock(running);
    if (known.is_null()) known = verification_json();
    return json_answer(known);
  });
}

}  // namespace talus::server
