#pragma once
// Routes requests to functions, checks access, and converts exceptions to answers.

#include <httplib.h>
#undef _res  // a macro of the resolver's header, and a name in Eigen's

#include <functional>
#include <string>
#include <vector>

#include "http/answer.hpp"
#include "http/limits.hpp"
#include "http/session.hpp"

namespace talus::server {

/// A request to the API that has passed the access checks.
struct Call {
  const httplib::Request& request;
  Json body{};  // of a POST, PUT or PATCH: an object

  /// Group k of the path's pattern; the first is 1.
  [[nodiscard]] std::string part(std::size_t k) const { return request.matches[k].str(); }
  /// A parameter of the query.
  [[nodiscard]] std::string query(const std::string& key, const std::string& default_value = {}) const;
  /// A parameter of the query as a whole number up to `most`. Refuses (400) other values.
  [[nodiscard]] std::uint64_t query_number(const std::string& key, std::uint64_t default_value,
                                           std::uint64_t most) const;

  // Values of the body. Refused (400) if missing or of another type; a default value replaces missing and null ones.
  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] std::string text(const std::string& key, const std::string& default_value) const;
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key, double default_value) const;
  /// Refuses (400) all other keys in the body.
  void only(std::initializer_list<const char*> keys) const;
};

class Router {
 public:
  using Handler = std::function<Answer(const Call&)>;
  using RawHandler = std::function<void(const httplib::Request&, httplib::Response&)>;
  using UploadHandler = std::function<Answer(const httplib::Request&, const httplib::ContentReader&)>;

  Router(httplib::Server& server, Session& session, Limits limits);

  void get(const std::string& pattern, Handler handler);
  void post(const std::string& pattern, Handler handler);
  void put(const std::string& pattern, Handler handler);
  void patch(const std::string& pattern, Handler handler);
  void remove(const std::string& pattern, Handler handler);
  /// A GET whose answer is sent in pieces. The handler may throw before the first one.
  void stream(const std::string& pattern, RawHandler handler);
  /// A PUT whose body is read in pieces.
  void upload(const std::string& pattern, UploadHandler handler);

  /// Refuses requests with a body that match no pattern. Call after adding all patterns.
  void refuse_other_bodies();

  /// Sets the port in the host names that requests may use.
  void set_port(int port);
  [[nodiscard]] const Limits& limits() const { return limits_; }

 private:
  /// False if the request was refused, with the answer in `response`.
  [[nodiscard]] bool check_access(const httplib::Request& request, httplib::Response& response) const;
  [[nodiscard]] static httplib::Server::Handler guarded(Handler handler);
  /// Reads the body as JSON, up to the limit of its size.
  [[nodiscard]] httplib::Server::HandlerWithContentReader guarded_with_body(Handler handler) const;

  httplib::Server& server_;
  Session& session_;
  Limits limits_;
  std::vector<std::string> hosts_;
};

}  // namespace talus::server
