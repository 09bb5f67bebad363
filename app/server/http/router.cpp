#include "http/router.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "http/ranges.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/json_text.hpp"

namespace talus::server {

namespace {

// Scripts, styles and pictures come from this server only, and no other page may frame this one. Inline styles are
// allowed because chart libraries set styles of elements.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob: data:; "
    "font-src 'self'; connect-src 'self'; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

void write_head(const Answer& answer, httplib::Response& response) {
  response.status = answer.status;
  for (const auto& [name, value] : answer.headers) response.set_header(name, value);
}

void write(const Answer& answer, httplib::Response& response) {
  write_head(answer, response);
  response.set_content(answer.body, answer.type);
}

/// Closes the connection after the answer, so that the rest of a body is not read as the next request.
void write_and_close(const Answer& answer, httplib::Response& response) {
  write_head(answer, response);
  response.set_header("Connection", "close");
  response.set_content_provider(
      answer.body.size(), answer.type,
      [body = answer.body](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        sink.write(body.data() + offset, length);
        return false;  // makes the library close the connection, although the answer is complete
      });
}

std::uint64_t declared_bytes(const httplib::Request& request) {
  return request.get_header_value<std::uint64_t>("Content-Length");
}

bool has_body(const httplib::Request& request) {
  return request.has_header("Transfer-Encoding") || declared_bytes(request) > 0;
}

/// A refused body up to this size is read, so that its connection can be used for the next request.
constexpr std::uint64_t most_drained = 1u << 20u;

enum class BodyState { unread, incomplete, complete };

/// Wraps `content` and tracks how much of the body was read.
httplib::ContentReader tracked(const httplib::ContentReader& content, BodyState& state) {
  const auto read = [&](httplib::ContentReceiver receiver) {
    state = BodyState::incomplete;
    if (content(std::move(receiver))) state = BodyState::complete;
    return state == BodyState::complete;
  };
  return {read, nullptr};
}

/// Reads the rest of a small body. Returns whether nothing of it is left on the connection.
bool drain(const httplib::Request& request, const httplib::ContentReader& content, BodyState state) {
  if (state != BodyState::unread) return state == BodyState::complete;
  if (!has_body(request)) return true;
  if (request.is_multipart_form_data()) return false;  // needs another reader of the library
  if (declared_bytes(request) > most_drained) return false;
  std::uint64_t bytes = 0;
  return content([&](const char*, std::size_t length) { return (bytes += length) <= most_drained; });
}

Answer refusal_answer(int status, const Problems& problems) {
  return json_answer({{"problems", as_json(problems)}}, status);
}

Answer refusal_answer(const Refusal& refusal) {
  Problems problems;
  problems.add(refusal.problem());
  return refusal_answer(refusal.status(), problems);
}

/// The function's answer, or a refusal if it throws.
Answer answer_of(const std::function<Answer()>& function) {
  try {
    return function();
  } catch (const Refusal& refusal) {
    return refusal_answer(refusal);
  } catch (const BadInput& bad) {
    return refusal_answer(422, bad.problems());
  } catch (const Stopped&) {
    return refusal_answer(
        Refusal(503, "", "the request was cancelled", "the server is shutting down, or the client has disconnected"));
  } catch (const std::bad_alloc&) {
    return refusal_answer(Refusal(500, "", "there is not enough memory for this request"));
  } catch (const std::exception& error) {
    return refusal_answer(Refusal(500, "", "the server failed", error.what()));
  }
}

/// Answers a request with a body, of which the function may have left a part unread.
void answer_body(const httplib::Request& request, httplib::Response& response, const httplib::ContentReader& content,
                 const std::function<Answer(const httplib::ContentReader&)>& function) {
  BodyState state = BodyState::unread;
  const httplib::ContentReader reader = tracked(content, state);
  const Answer answer = answer_of([&] { return function(reader); });
  if (drain(request, content, state)) {
    write(answer, response);
  } else {
    write_and_close(answer, response);
  }
}

Json read_body(const httplib::Request& request, const httplib::ContentReader& content, const Limits& limits) {
  const std::string type = request.get_header_value("Content-Type");
  if (type.substr(0, type.find(';')) != "application/json")
    throw Refusal(415, "Content-Type", fmt::format("\"{}\" is not supported", type), "expected application/json");
  std::string text;
  bool is_too_large = false;
  const bool is_whole = content([&](const char* data, std::size_t length) {
    is_too_large = length > limits.json_bytes - text.size();
    if (!is_too_large) text.append(data, length);
    return !is_too_large;
  });
  if (is_too_large)
    throw Refusal(413, "", "the request is too large", fmt::format("at most {} bytes are accepted", limits.json_bytes));
  if (!is_whole) throw Refusal(400, "", "the request's body is incomplete");
  if (depth_of_json(text) > deepest_json) throw Refusal(400, "", "lists in the request are nested too deeply");
  Json body = Json::parse(text, nullptr, false);
  if (body.is_discarded()) throw Refusal(400, "", "the request's body is not JSON");
  if (!body.is_object()) throw Refusal(400, "", "the request's body is not a JSON object");
  return body;
}

}  // namespace

std::string Call::query(const std::string& key, const std::string& default_value) const {
  return request.has_param(key) ? request.get_param_value(key) : default_value;
}

std::uint64_t Call::query_number(const std::string& key, std::uint64_t default_value, std::uint64_t most) const {
  if (!request.has_param(key)) return default_value;
  const std::string text = request.get_param_value(key);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number > most)
    throw Refusal(400, key, fmt::format("\"{}\" is not a valid number", text),
                  fmt::format("expected a whole number from 0 to {}", most));
  return number;
}

std::string Call::text(const std::string& key) const {
  const auto found = body.find(key);
  if (found == body.end()) throw Refusal(400, key, "is missing");
  if (!found->is_string()) throw Refusal(400, key, "is not a text");
  return found->get<std::string>();
}

std::string Call::text(const std::string& key, const std::string& default_value) const {
  const auto found = body.find(key);
  return found == body.end() || found->is_null() ? default_value : text(key);
}

double Call::number(const std::string& key) const {
  const auto found = body.find(key);
  if (found == body.end()) throw Refusal(400, key, "is missing");
  if (!found->is_number()) throw Refusal(400, key, "is not a number");
  return found->get<double>();
}

double Call::number(const std::string& key, double default_value) const {
  const auto found = body.find(key);
  return found == body.end() || found->is_null() ? default_value : number(key);
}

void Call::only(std::initializer_list<const char*> keys) const {
  for (const auto& [key, value] : body.items()) {
    const bool known =
        std::any_of(keys.begin(), keys.end(), [&given = key](const char* name) { return given == name; });
    if (!known) throw Refusal(400, key, "is not a key of this request");
  }
}

Router::Router(httplib::Server& server, Session& session, Limits limits)
    : server_(server), session_(session), limits_(limits) {
  // Set on every answer, including refusals and files.
  server_.set_default_headers({{"Content-Security-Policy", content_policy},
                               {"X-Content-Type-Options", "nosniff"},
                               {"Referrer-Policy", "same-origin"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"Cross-Origin-Opener-Policy", "same-origin"},
                               {"Cache-Control", "no-store"}});
  server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    return check_access(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                           : httplib::Server::HandlerResponse::Handled;
  });
  server_.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
    if (!response.body.empty() || response.content_length_ > 0) return;
    const int status = response.status;
    write(refusal_answer(status == 404 ? Refusal(404, request.path, "not found")
                                       : Refusal(status, request.path, "the request is not valid")),
          response);
  });
}

void Router::refuse_other_bodies() {
  // The library would read the body into memory before answering 404.
  const auto refuse = [](const httplib::Request& request, httplib::Response& response,
                         const httplib::ContentReader& content) {
    answer_body(request, response, content,
                [&](const httplib::ContentReader&) -> Answer { throw Refusal(404, request.path, "not found"); });
  };
  server_.Post(".*", refuse);
  server_.Put(".*", refuse);
  server_.Patch(".*", refuse);
}

void Router::set_port(int port) {
  for (const char* name : {"127.0.0.1", "localhost"}) hosts_.push_back(fmt::format("{}:{}", name, port));
}

// A page of another site in the user's browser can send requests here: such a request has a foreign Origin, or, if the
// site's name resolves to this machine, a foreign Host.
bool Router::check_access(const httplib::Request& request, httplib::Response& response) const {
  const auto is_ours = [&](const std::string& host) {
    return std::find(hosts_.begin(), hosts_.end(), host) != hosts_.end();
  };
  const auto refuse = [&](int status, const char* where, const char* what, const char* hint = "") {
    const Answer answer = refusal_answer(Refusal(status, where, what, "", hint));
    if (has_body(request)) {
      write_and_close(answer, response);
    } else {
      write(answer, response);
    }
    return false;
  };
  for (const char* name : {"Host", "Content-Length"}) {
    if (request.get_header_value_count(name) < 2) continue;
    write_and_close(refusal_answer(Refusal(400, name, "occurs twice in this request")), response);
    return false;
  }
  const std::string length = request.get_header_value("Content-Length");
  if (length.find_first_not_of("0123456789") != std::string::npos) {
    write_and_close(refusal_answer(Refusal(400, "Content-Length", "is not a number")), response);
    return false;
  }
  if (!is_ours(request.get_header_value("Host")))
    return refuse(403, "Host", "this is not the server's name", "Use the address that it printed");
  if (request.has_header("Origin")) {
    const std::string origin = request.get_header_value("Origin");
    if (!origin.starts_with("http://") || !is_ours(origin.substr(7)))
      return refuse(403, "Origin", "requests from other sites are not allowed");
  }
  // "/" opens a session, or shows that there is none.
  const bool reads = request.method == "GET" || request.method == "HEAD";
  const bool is_open = request.path == "/" && reads;
  if (!is_open && !session_.accepts(request.get_header_value("Cookie")))
    return refuse(403, "", "this browser has no session", "Open the address that `talus serve` printed");
  const bool takes_a_body = request.method == "POST" || request.method == "PUT" || request.method == "PATCH";
  if (!reads && !takes_a_body && request.method != "DELETE") return refuse(405, "", "this method is not supported");
  if (!takes_a_body && has_body(request)) return refuse(400, "", "this request must not have a body");
  if (request.has_header("Transfer-Encoding"))
    return refuse(411, "Transfer-Encoding", "is not supported", "Send a Content-Length");
  if (asks_for_several_parts(request)) return refuse(416, "Range", "has several parts", "Request one at a time");
  return true;
}

httplib::Server::Handler Router::guarded(Handler handler) {
  return [handler = std::move(handler)](const httplib::Request& request, httplib::Response& response) {
    write(answer_of([&] { return handler(Call{request}); }), response);
    apply_range(request, response);
  };
}

httplib::Server::HandlerWithContentReader Router::guarded_with_body(Handler handler) const {
  return [this, handler = std::move(handler)](const httplib::Request& request, httplib::Response& response,
                                              const httplib::ContentReader& content) {
    answer_body(request, response, content, [&](const httplib::ContentReader& body) {
      return handler(Call{request, read_body(request, body, limits_)});
    });
  };
}

void Router::get(const std::string& pattern, Handler handler) { server_.Get(pattern, guarded(std::move(handler))); }
void Router::post(const std::string& pattern, Handler handler) {
  server_.Post(pattern, guarded_with_body(std::move(handler)));
}
void Router::put(const std::string& pattern, Handler handler) {
  server_.Put(pattern, guarded_with_body(std::move(handler)));
}
void Router::patch(const std::string& pattern, Handler handler) {
  server_.Patch(pattern, guarded_with_body(std::move(handler)));
}
void Router::remove(const std::string& pattern, Handler handler) {
  server_.Delete(pattern, guarded(std::move(handler)));
}

void Router::stream(const std::string& pattern, RawHandler handler) {
  server_.Get(pattern, [handler = std::move(handler)](const httplib::Request& request, httplib::Response& response) {
    bool has_begun = false;
    const Answer answer = answer_of([&] {
      handler(request, response);
      has_begun = true;
      return Answer{};
    });
    if (!has_begun) write(answer, response);
    apply_range(request, response);
  });
}

void Router::upload(const std::string& pattern, UploadHandler handler) {
  server_.Put(pattern, [handler = std::move(handler)](const httplib::Request& request, httplib::Response& response,
                                                      const httplib::ContentReader& content) {
    answer_body(request, response, content, [&](const httplib::ContentReader& body) {
      if (request.get_header_value("Content-Type") != "application/octet-stream")
        throw Refusal(415, "Content-Type", "this type is not supported", "expected application/octet-stream");
      return handler(request, body);
    });
  });
}

}  // namespace talus::server
