#include "talus/calibration/saved_samples.hpp"

#include "talus/core/bytes.hpp"

namespace talus::calibration {

namespace {

void write_sample(const Sample& sample, ByteWriter& out) {
  out.put(static_cast<std::uint64_t>(sample.rows.rows()));
  out.put(static_cast<std::uint64_t>(sample.rows.cols()));
  out.numbers(std::span<const double>(sample.rows.data(), static_cast<std::size_t>(sample.rows.size())));
  out.list(sample.strata);
  out.list(sample.rocks);
}

Sample read_sample(ByteReader& in) {
  const auto rows = in.get<std::uint64_t>(), columns = in.get<std::uint64_t>();
  expect_bytes(columns <= 8 && rows <= in.left() / sizeof(double), "a sample is too large");
  Sample sample;
  sample.rows.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  expect_bytes(rows * columns <= in.left() / sizeof(double), "a sample is too large");
  in.numbers(std::span<double>(sample.rows.data(), static_cast<std::size_t>(sample.rows.size())));
  sample.strata = in.list<std::uint32_t>();
  sample.rocks = in.list<std::uint32_t>();
  const auto is_complete = [&](const std::vector<std::uint32_t>& list) { return list.empty() || list.size() == rows; };
  expect_bytes(is_complete(sample.strata) && is_complete(sample.rocks), "a sample is incomplete");
  return sample;
}

}  // namespace

std::string bytes_of(const std::vector<Sample>& samples) {
  ByteWriter out;
  out.count(samples.size());
  for (const Sample& sample : samples) write_sample(sample, out);
  return out.take();
}

std::optional<std::vector<Sample>> samples_in(std::string_view bytes) {
  try {
    ByteReader in(bytes);
    std::vector<Sample> samples;
    const std::size_t groups = in.count(1);
    for (std::size_t g = 0; g < groups; ++g) samples.push_back(read_sample(in));
    in.expect_end();
    return samples;
  } catch (const BadBytes&) {
    return std::nullopt;
  }
}

}  // namespace talus::calibration
