#include "events.hpp"
#include "results/run_summary.hpp"
#include "routes/results.hpp"
#include "routes/routes.hpp"
#include "run_store.hpp"
#include "talus/project/differences.hpp"

namespace talus::server {

namespace {

/// A whole number of the body; nullopt if it is missing or null.
template <class Number>
std::optional<Number> number_in(const Call& call, const char* key) {
  const auto found = call.body.find(key);
  if (found == call.body.end() || found->is_null()) return std::nullopt;
  if (!found->is_number_unsigned()) throw Refusal(400, key, "is not a whole number", "expected 0 or more");
  const auto number = found->template get<std::uint64_t>();
  if (!std::in_range<Number>(number)) throw Refusal(400, key, "is too large");
  return static_cast<Number>(number);
}

}  // namespace

void add_run_routes(Router& router, RunStore& runs, EventHub& events) {
  router.post("/api/runs", [&runs](const Call& call) {
    call.only({"file", "text", "name", "rocks", "seed"});
    const Run run = runs.begin({.file = call.text("file"),
                                .text = call.text("text"),
                                .name = call.text("name", ""),
                                .rocks = number_in<std::int64_t>(call, "rocks"),
                                .seed = number_in<std::uint64_t>(call, "seed")});
    return json_answer(runs.json_of(run), 202);
  });
  router.get("/api/runs", [&runs](const Call&) {
    Json list = Json::array();
    for (const Run& run : runs.list()) list.push_back(runs.json_of(run));
    return json_answer({{"runs", std::move(list)}});
  });
  router.get(one_run, [&runs](const Call& call) { return json_answer(runs.json_of(runs.find(call.part(1)))); });
  router.patch(one_run, [&runs](const Call& call) {
    call.only({"name"});
    return json_answer(runs.json_of(runs.rename(call.part(1), call.text("name"))));
  });
  router.post(one_run + "/stop", [&runs](const Call& call) {
    call.only({});
    return json_answer(runs.json_of(runs.stop(call.part(1))));
  });
  router.post(one_run + "/resume", [&runs](const Call& call) {
    call.only({});
    return json_answer(runs.json_of(runs.resume(call.part(1))), 202);
  });
  router.post(one_run + "/write", [&runs](const Call& call) {
    call.only({});
    return json_answer(runs.json_of(runs.write_results(call.part(1))), 202);
  });
  router.remove(one_run, [&runs](const Call& call) {
    runs.remove(call.part(1));
    return json_answer({{"id", call.part(1)}});
  });
  router.get(one_run + "/differences/([A-Za-z0-9._-]+)", [&runs](const Call& call) {
    const Run here = runs.find(call.part(1)), there = runs.find(call.part(2));
    Json list = Json::array();
    for (const project::Difference& difference :
         project::differences(settings_of(here, runs.project_file(here)), settings_of(there, runs.project_file(there))))
      list.push_back({{"key", difference.key}, {"here", difference.here}, {"there", difference.there}});
    return json_answer({{"differences", std::move(list)}});
  });
  router.stream("/api/events", [&events](const httplib::Request&, httplib::Response& response) {
    response.set_chunked_content_provider(
        "text/event-stream", [listener = events.listen()](std::size_t, httplib::DataSink& sink) {
          const auto text = listener->next();
          if (!text) {
            sink.done();
            return true;
          }
          return sink.is_writable() && (text->empty() || sink.write(text->data(), text->size()));
        });
  });
}

}  // namespace talus::server
