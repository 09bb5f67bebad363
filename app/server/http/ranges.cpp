#include "http/ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "http/answer.hpp"

namespace talus::server {

namespace {

httplib::Ranges ranges_of(const httplib::Request& request) {
  httplib::Ranges ranges;
  if (request.has_header("Range")) httplib::detail::parse_range_header(request.get_header_value("Range"), ranges);
  return ranges;
}

struct Part {
  std::size_t first = 0, count = 0;  // bytes
};

/// `range`: first and last byte; -1 is none. Without a first, the last bytes, as many as the second number says.
Part part_of(std::size_t bytes, const httplib::Range& range) {
  const auto within = [&](auto number) { return number < 0 ? 0 : std::min(static_cast<std::size_t>(number), bytes); };
  if (range.first < 0) return {bytes - within(range.second), within(range.second)};
  const std::size_t first = within(range.first), before_last = within(range.second);
  const std::size_t end = range.second < 0 || before_last == bytes ? bytes : before_last + 1;
  return first < end ? Part{first, end - first} : Part{};
}

void refuse(httplib::Response& response, std::size_t bytes) {
  Problems problems;
  problems.add(
      {.where = "Range", .what = "begins beyond the end of the answer", .why = fmt::format("it has {} bytes", bytes)});
  response.status = 416;
  response.content_provider_ = nullptr;
  response.content_length_ = 0;
  response.headers.erase("Content-Encoding");
  response.set_header("Content-Range", fmt::format("bytes */{}", bytes));
  const Answer answer = json_answer({{"problems", as_json(problems)}});
  response.set_content(answer.body, answer.type);
}

}  // namespace

bool asks_for_several_parts(const httplib::Request& request) { return ranges_of(request).size() > 1; }

void apply_range(const httplib::Request& request, httplib::Response& response) {
  if (request.method != "GET" && request.method != "HEAD") return;
  const httplib::Ranges ranges = ranges_of(request);
  const bool is_whole = response.status == -1 || response.status == 200;
  if (ranges.size() != 1 || !is_whole || response.is_chunked_content_provider_) return;
  const bool is_text = response.content_provider_ == nullptr;
  const std::size_t bytes = is_text ? response.body.size() : response.content_length_;
  const Part part = part_of(bytes, ranges.front());
  if (part.count == 0) return refuse(response, bytes);
  response.status = 206;
  response.set_header("Content-Range", fmt::format("bytes {}-{}/{}", part.first, part.first + part.count - 1, bytes));
  if (is_text) {
    response.body = response.body.substr(part.first, part.count);
    return;
  }
  response.content_length_ = part.count;
  response.content_provider_ = [first = part.first, whole = std::move(response.content_provider_)](
                                   std::size_t offset, std::size_t length, httplib::DataSink& sink) {
    return whole(first + offset, length, sink);
  };
}

}  // namespace talus::server
