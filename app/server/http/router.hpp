#pragma once
// From requests to functions: who may ask is settled here, and what is thrown becomes an answer.

#include <httplib.h>
#undef _res  // a macro of the resolver's header, and a name in Eigen's

#include <functional>
#include <string>
#include <vector>

#include "http/answer.hpp"
#include "http/limits.hpp"
#include "http/session.hpp"

namespace talus::server {

/// A request to the API by somebody who may make it.
struct Call {
  const httplib::Request& request;
  Json body{};  // of a POST, PUT or PATCH: an object

  /// The k-th group of the path's pattern, counted from 1.
  [[nodiscard]] std::string part(std::size_t k) const { return request.matches[k].str(); }
  /// A parameter of the query; `otherwise` where there is none.
  [[nodiscard]] std::string query(const std::string& key, const std::string& otherwise = {}) const;
  /// The same as a whole number of a range; refused if it is none.
  [[nodiscard]] std::uint64_t query_number(const std::string& key, std::uint64_t otherwise, std::uint64_t most) const;

  // Keys of the body; refused where missing or of another type. With `otherwise`, it stands for one that is missing or
  // null.
  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise) const;
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key, double otherwise) const;
  /// Refuses keys of the body that are none of these.
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
  /// For answers that come bit by bit; it may throw before it begins.
  void stream(const std::string& pattern, RawHandler handler);
  /// A PUT whose body is read bit by bit.
  void upload(const std::string& pattern, UploadHandler handler);

  /// Refuses bodies that no pattern takes. To be called when all patterns are there.
  void refuse_the_rest();

  /// Under which names this server is asked, once its port is known.
  void listens_on(int port);
  [[nodiscard]] const Limits& limits() const { return limits_; }

 private:
  [[nodiscard]] bool lets_in(const httplib::Request& request, httplib::Response& response) const;
  [[nodiscard]] static httplib::Server::Handler guarded(Handler handler);
  /// No more of the body is taken than is allowed of JSON.
  [[nodiscard]] httplib::Server::HandlerWithContentReader guarded_with_body(Handler handler) const;

  httplib::Server& server_;
  Session& session_;
  Limits limits_;
  std::vector<std::string> hosts_;
};

}  // namespace talus::server
