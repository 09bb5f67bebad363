#include "events.hpp"
#include "routes/routes.hpp"
#include "run_store.hpp"

namespace talus::server {

namespace {

/// A whole number of the body; nothing where it is missing or null.
template <class Number>
std::optional<Number> number_in(const Call& call, const char* key) {
  const auto found = call.body.find(key);
  if (found == call.body.end() || found->is_null()) return std::nullopt;
  if (!found->is_number_unsigned()) throw Refusal(400, key, "is no whole number", "expected 0 or more");
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
    return json_answer(runs.told(run), 202);
  });
  router.get("/api/runs", [&runs](const Call&) {
    Json list = Json::array();
    for (const Run& run : runs.list()) list.push_back(runs.told(run));
    return json_answer({{"runs", std::move(list)}});
  });
  const std::string one = R"(/api/runs/([A-Za-z0-9._-]+))";
  router.get(one, [&runs](const Call& call) { return json_answer(runs.told(runs.find(call.part(1)))); });
  router.patch(one, [&runs](const Call& call) {
    call.only({"name"});
    return json_answer(runs.told(runs.rename(call.part(1), call.text("name"))));
  });
  router.post(one + "/stop", [&runs](const Call& call) {
    call.only({});
    return json_answer(runs.told(runs.stop(call.part(1))));
  });
  router.post(one + "/resume", [&runs](const Call& call) {
    call.only({});
    return json_answer(runs.told(runs.resume(call.part(1))), 202);
  });
  router.remove(one, [&runs](const Call& call) {
    runs.remove(call.part(1));
    return json_answer({{"id", call.part(1)}});
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
