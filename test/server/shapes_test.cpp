// Geometry and distributions without a model, and the published cases.

#include "server/served.hpp"

#include "talus/sampling/distribution.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Served;

using Shapes = Served;

Json square(double x, double z) { return {{x, 0, z}, {x + 1, 0, z}, {x + 1, 1, z}, {x, 1, z}, {x, 0, z}}; }

TEST_F(Shapes, TriangulatesClosedPolylines) {
  const Reply reply = post("/api/geometry/polygons", {{"polylines", {square(0, 5), square(1.0005, 5)}}});
  EXPECT_EQ(reply.status, 200);
  const Json made = reply.json();
  EXPECT_TRUE(made["problems"].empty());
  EXPECT_EQ(made["vertices"].size(), 6U);  // two vertices of each are within a millimetre
  EXPECT_EQ(made["triangles"].size(), 4U);
  EXPECT_NE(made["report"].get<std::string>().find("polygons: 2, cut into 4 triangles"), std::string::npos);
  const Json apart =
      post("/api/geometry/polygons", {{"polylines", {square(0, 5), square(1.0005, 5)}}, {"tolerance_m", 1e-4}}).json();
  EXPECT_EQ(apart["vertices"].size(), 8U);
}

TEST_F(Shapes, NamesTheInvalidPolyline) {
  Json open = square(3, 0);
  open.erase(4);
  const Json crossing{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  for (const auto& [wrong, what] :
       {std::pair(open, "polylines[1] is not closed"), std::pair(crossing, "polylines[1] crosses itself at (")}) {
    const Json made = post("/api/geometry/polygons", {{"polylines", {square(0, 5), wrong}}}).json();
    ASSERT_EQ(made["problems"].size(), 1U);
    EXPECT_EQ(made["problems"][0]["path"], "polylines.1");
    EXPECT_TRUE(made["problems"][0]["what"].get<std::string>().starts_with(what)) << made["problems"].dump();
    EXPECT_TRUE(made["triangles"].empty());
  }
  EXPECT_EQ(post("/api/geometry/polygons", {{"polylines", Json::array()}}).status, 400);
  EXPECT_EQ(post("/api/geometry/polygons", {{"polylines", {{{0, 0}}}}}).status, 400);
  EXPECT_EQ(post("/api/geometry/polygons", {{"polylines", {square(0, 0)}}, {"tolerance_m", -1}}).status, 400);
}

TEST_F(Shapes, HasTheDensityOfTheSampler) {
  const Json body{{"key", "normal_restitution"}, {"mean", 0.9}, {"distribution", "normal"}, {"std_dev", 0.1}};
  const Json density = post("/api/distribution", body).json()["density"];
  const Sampler sampler(Distribution{0.9, DistributionKind::normal, 0.1, {}, {}}, Bounds{0, 1});
  // The sum over the curve up to each place must be the share of draws below it.
  const double width = density[1][0].get<double>() - density[0][0].get<double>();
  double sum = 0;
  for (const Json& each : density) {
    sum += each[1].get<double>() * width;
    const double right = each[0].get<double>() + width / 2;
    double u = 0, step = 0.5;  // the share of draws below `right`, by bisection of the sampler
    for (; step > 1e-9; step /= 2)
      if (sampler.draw(u + step) <= right) u += step;
    EXPECT_NEAR(sum, u, 0.0011);  // the curve leaves out the lower tail, a thousandth
  }
  EXPECT_NEAR(density.back()[0].get<double>() + width / 2, 1, 1e-12);  // the upper bound of a restitution
  const Json plain = post("/api/distribution", {{"mean", 0.9}, {"distribution", "normal"}, {"std_dev", 0.1}}).json();
  EXPECT_GT(plain["density"].back()[0].get<double>(), 1.1);
}

TEST_F(Shapes, ReadsAPlainRoughnessAsAStandardDeviation) {
  const Json density = post("/api/distribution", {{"key", "roughness_deg"}, {"mean", 3}}).json()["density"];
  ASSERT_FALSE(density.empty());
  EXPECT_NEAR(density.front()[0].get<double>(), -density.back()[0].get<double>(), 1e-6);
  EXPECT_TRUE(post("/api/distribution", {{"key", "dynamic_friction"}, {"mean", 3}}).json()["density"].empty());
}

TEST_F(Shapes, RefusesInvalidDistributions) {
  const Json beta = post("/api/distribution", {{"mean", 1}, {"distribution", "beta"}}).json();
  EXPECT_EQ(beta["problems"][0]["text"], "std_dev is missing (the beta distribution needs it)");
  EXPECT_TRUE(beta["density"].empty());
  EXPECT_EQ(post("/api/distribution", {{"mean", 1}, {"distribution", "bet"}}).problem(),
            "distribution: \"bet\" is not a distribution (expected one of none, normal, uniform, triangular, beta, "
            "exponential, lognormal, gamma, empirical)");
  EXPECT_EQ(post("/api/distribution", {{"mean", 1}, {"key", "colour"}}).problem(),
            "key: \"colour\" is not a random property");
}

TEST_F(Shapes, ShowsThePublishedCases) {
  const Json cases = get("/api/verification").json();
  EXPECT_TRUE(cases["passes"].get<bool>());
  ASSERT_EQ(cases["cases"].size(), 8U);
  for (const Json& each : cases["cases"]) {
    EXPECT_EQ(each["agree"], each["compared"]);
    EXPECT_GT(each["compared"].get<int>(), 40);
    EXPECT_FALSE(each["tables"].empty());
  }
  const Json again = get("/api/verification").json();
  EXPECT_EQ(again, cases);  // including the times: the cases were not run again
}

}  // namespace
}  // namespace talus
