#include <fmt/format.h>

#include <algorithm>

#include "assets.hpp"
#include "http/ranges.hpp"
#include "routes/routes.hpp"

namespace talus::server {

namespace {

void send(const Asset& asset, const httplib::Request& request, httplib::Response& response) {
  response.set_header("Content-Encoding", "gzip");
  // The names of assets, but not of the page itself, change with their contents.
  if (asset.path.starts_with("assets/")) response.set_header("Cache-Control", "private, max-age=31536000, immutable");
  response.set_content_provider(asset.bytes.size(), std::string(asset.type),
                                [asset](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(asset.bytes.data() + offset, length);
                                });
  apply_range(request, response);
}

constexpr const char* used_token =
    "<!doctype html><meta charset=utf-8><title>Talus</title><body style='font:16px "
    "sans-serif;margin:3em;max-width:36em'>"
    "<h1>This address has been used</h1><p>It works only once. Start <code>talus serve</code> again to get a new one, "
    "or "
    "use <i>Address for another browser</i> on a start page that is still open.</p>";

constexpr const char* no_session =
    "<!doctype html><meta charset=utf-8><title>Talus</title><body style='font:16px "
    "sans-serif;margin:3em;max-width:36em'>"
    "<h1>This browser has no session</h1><p>Open the address that <code>talus serve</code> printed.</p>";

}  // namespace

void add_page_routes(Router& router, httplib::Server& server, Session& session,
                     const std::function<std::string()>& address) {
  const auto find = [](const std::string& path) {
    const auto& assets = page_assets();
    return std::find_if(assets.begin(), assets.end(), [&](const Asset& asset) { return asset.path == path; });
  };
  server.Get("/", [&session, find](const httplib::Request& request, httplib::Response& response) {
    const bool has_session = session.accepts(request.get_header_value("Cookie"));
    if (request.has_param("token")) {
      if (session.use_token(request.get_param_value("token"))) {
        response.set_header("Set-Cookie", session.cookie());
      } else if (!has_session) {
        response.status = 403;
        response.set_content(used_token, "text/html; charset=utf-8");
        return;
      }
      response.set_redirect("/", 303);  // so that the token does not stay in the address bar
      return;
    }
    if (!has_session) {
      response.status = 403;
      response.set_content(no_session, "text/html; charset=utf-8");
      return;
    }
    send(*find("index.html"), request, response);
  });
  server.Get(R"(/([A-Za-z0-9._/-]+))", [find](const httplib::Request& request, httplib::Response& response) {
    const auto asset = find(request.matches[1].str());
    if (asset == page_assets().end()) {
      response.status = 404;
      return;
    }
    send(*asset, request, response);
  });
  router.post("/api/tokens", [address](const Call& call) {
    call.only({});
    return json_answer({{"address", address()}});
  });
}

}  // namespace talus::server
