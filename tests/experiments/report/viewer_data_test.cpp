#include "experiments/report/viewer_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What the page does with the data, written once more: see web/src/decode.js.
class Decoder {
 public:
  explicit Decoder(const ViewerData& data)
      : header(nlohmann::json::parse(data.header)), arrays_(data.arrays) {
    const std::size_t points = header["points"]["count"], vertices = header["mesh"]["vertices"];
    places_ = 12 * header["mesh"]["triangles"].get<std::size_t>();
    vertices_ = places_ + 6 * points;
    bytes_ = vertices_ + 6 * vertices;
  }

  Eigen::Vector3d Point(std::size_t i) const { return Place(places_ + 6 * i); }
  Eigen::Vector3d Vertex(std::size_t i) const { return Place(vertices_ + 6 * i); }
  std::uint32_t Corner(std::size_t i) const { return Word(4 * i) + (Word(4 * i + 2) << 16U); }
  unsigned Byte(std::size_t i) const { return static_cast<unsigned char>(arrays_.at(bytes_ + i)); }
  std::size_t BytesLeft() const { return arrays_.size() - bytes_; }

  nlohmann::json header;

 private:
  unsigned Word(std::size_t at) const {
    return static_cast<unsigned char>(arrays_.at(at)) +
           256U * static_cast<unsigned char>(arrays_.at(at + 1));
  }
  Eigen::Vector3d Place(std::size_t at) const {
    Eigen::Vector3d p;
    for (int a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double min = header["box"]["min"][axis], size = header["box"]["size"][axis];
      p[a] = min + size * Word(at + 2 * axis) / 65535.0;
    }
    return p;
  }

  std::string arrays_;
  std::size_t places_ = 0, vertices_ = 0, bytes_ = 0;
};

/// Two scans of random points, of which the first belongs to the later step.
ViewerScene RandomScene(std::size_t points) {
  RandomStream random = NamedStream(7, "viewer");
  ViewerScene scene;
  scene.stops = {{"late", {}, 5}, {"early", {}, 2}};
  scene.has_reflectance = true;
  for (std::size_t i = 0; i < points; ++i) {
    const auto coordinate = [&] { return static_cast<float>(DrawUniform(random, -10.0, 10.0)); };
    scene.points.push_back({{coordinate(), coordinate(), coordinate()},
                            static_cast<float>(i % 101),
                            static_cast<std::uint32_t>(i % 2)});
  }
  return scene;
}

TEST(EncodeScene, KeepsPointsToTheirResolution) {
  const ViewerScene scene = RandomScene(1000);
  const Decoder decoded(EncodeScene(scene, {}));
  ASSERT_EQ(decoded.header["points"]["count"], 1000);
  EXPECT_EQ(decoded.header["stops"][0]["name"], "early");
  EXPECT_EQ(decoded.header["stops"][0]["points"], 500);
  for (std::size_t i = 0; i < 1000; ++i) {  // the odd ones are those of the early stop
    const ViewerPoint& point = scene.points[i < 500 ? 2 * i + 1 : 2 * (i - 500)];
    EXPECT_LT((decoded.Point(i) - point.p_map.cast<double>()).norm(), 20.0 / 65535.0);
    EXPECT_NEAR(decoded.Byte(i), 255.0 * (point.reflectance - 1.0) / 98.0, 3.0);
  }
  EXPECT_EQ(decoded.BytesLeft(), 1000U);
}

TEST(EncodeScene, KeepsTheMesh) {
  ViewerScene scene;
  scene.mesh_map = {{{0, 0, 0}, {4, 0, 0}, {4, 2, 1}, {70'000, 0, 0}},
                    {{0, 1, 2}, {3, 2, 1}},
                    {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}}};
  const Decoder decoded(EncodeScene(scene, {}));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((decoded.Vertex(i) - scene.mesh_map.vertices[i]).norm(), 70'000 / 65535.0);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(decoded.Corner(i), scene.mesh_map.triangles[i / 3][i % 3]);
  EXPECT_EQ(decoded.Byte(11), 252U);
  EXPECT_EQ(decoded.BytesLeft(), 12U);
}

TEST(EncodeScene, HoldsWhatStandsBesideThePoints) {
  ViewerScene scene;
  scene.stops = {{"</script><b>\xff", {Eigen::Quaterniond::Identity(), {1, 2, 3}}, 0}};
  scene.boxes = {{slam::Box3(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 4)), {}, 3}};
  scene.driven = {{{{0, 0, 0}, {1, 0, 0.00001}}, 1}};
  scene.polygons = {{{{{{0, 0}, true}, {{1, 0}, false}, {{1, 1}, true}}, {}}, 1.5, 2}};
  const ViewerData data = EncodeScene(scene, {});
  EXPECT_THAT(data.header, Not(HasSubstr("<")));
  const Decoder decoded(data);
  EXPECT_EQ(decoded.header["stops"][0]["name"], "</script><b>\xef\xbf\xbd");
  EXPECT_EQ(decoded.header["stops"][0]["ahead"].dump(), "[1.0,0.0,0.0]");
  EXPECT_EQ(decoded.header["boxes"][0]["center"].dump(), "[0.5,1.0,2.0]");
  EXPECT_EQ(decoded.header["boxes"][0]["step"], 3);
  EXPECT_EQ(decoded.header["driven"][0]["points"].dump(), "[[0.0,0.0,0.0],[1.0,0.0,0.0]]");
  EXPECT_EQ(decoded.header["polygons"][0]["rings"].dump(), "[[[0.0,0.0,1],[1.0,0.0,0],[1.0,1.0,1]]]");
  EXPECT_EQ(decoded.header["colors"]["height"].size(), 9U);
}

TEST(EncodeScene, ThinsEachScanByItself) {
  ViewerScene scene = RandomScene(0);
  for (int i = 0; i < 1000; ++i) {  // both scans see the same wall
    for (const std::uint32_t stop : {0U, 1U})
      scene.points.push_back({{0.001F * static_cast<float>(i), 0.0F, 0.0F}, 0.0F, stop});
  }
  const Decoder decoded(EncodeScene(scene, {.max_points = 100}));
  const double spacing = decoded.header["points"]["spacing"];
  EXPECT_EQ(decoded.header["points"]["of"], 2000);
  EXPECT_EQ(decoded.header["points"]["count"], 2 * decoded.header["stops"][0]["points"].get<int>());
  EXPECT_NEAR(decoded.header["points"]["count"], 2.0 / spacing, 2.0);
  EXPECT_LE(decoded.header["points"]["count"], 100);
  EXPECT_GE(decoded.header["points"]["count"], 20) << "not thinner than it need be";
}

TEST(EncodeScene, ThinsTheMesh) {
  ViewerScene scene;
  for (std::uint32_t i = 0; i < 100; ++i) {
    for (std::uint32_t k = 0; k < 100; ++k) scene.mesh_map.vertices.emplace_back(0.1 * i, 0.1 * k, 0.0);
  }
  for (std::uint32_t i = 0; i + 101 < 10'000; ++i) {
    scene.mesh_map.triangles.push_back({i, i + 100, i + 1});
    scene.mesh_map.triangles.push_back({i + 1, i + 100, i + 101});
  }
  const Decoder decoded(EncodeScene(scene, {.max_triangles = 2000}));
  const std::size_t triangles = decoded.header["mesh"]["triangles"],
                    vertices = decoded.header["mesh"]["vertices"];
  EXPECT_LE(triangles, 2000U);
  EXPECT_GE(triangles, 200U);
  EXPECT_LT(vertices, triangles);
  for (std::size_t i = 0; i < 3 * triangles; ++i) EXPECT_LT(decoded.Corner(i), vertices);
}

TEST(EncodeScene, StaysBelowTenMegabytesPerMillionPoints) {
  const ViewerData data = EncodeScene(RandomScene(50'000), {});
  EXPECT_LT(data.header.size() + Base64(data.arrays).size(), 500'000U);
}

TEST(EncodeScene, RefusesWhatIsNowhere) {
  ViewerScene far = RandomScene(1), lost = RandomScene(1), foreign = RandomScene(1);
  far.points[0].p_map.x() = 1e7F;
  lost.driven = {{{{0, 0, std::numeric_limits<double>::quiet_NaN()}}, 0}};
  foreign.points[0].stop = 2;
  for (const ViewerScene& scene : {far, lost, foreign}) EXPECT_THROW(EncodeScene(scene, {}), Error);
}

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Base64(std::string("\x00\xff\xfe", 3)), "AP/+");
}

}  // namespace
}  // namespace ariadne::experiments
