#include "slam/registration/correspondences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/slam/registration/same_correspondences.h"
#include "tests/support/brute_force.h"
#include "tests/support/difficult_clouds.h"

namespace ariadne::slam {
namespace {

class CorrespondencesIn : public testing::TestWithParam<NamedCloud> {
 protected:
  const std::vector<Eigen::Vector3d>& model_ = GetParam().points;
  const std::vector<Eigen::Vector3d> data_ = QueriesFor(model_);
  const KdTree tree_{model_};
};
INSTANTIATE_TEST_SUITE_P(Clouds, CorrespondencesIn, testing::ValuesIn(DifficultClouds()), NameForTest);

TEST_P(CorrespondencesIn, AreTheNearestByDefinitionHoweverTheyAreFound) {
  RandomStream stream = NamedStream(1, "correspondences_test");
  for (int i = 0; i < 10; ++i) {
    const Pose3 T = i == 0 ? Pose3() : DrawMotion(stream, 0.2, 0.1);
    for (const double gate : {0.0, 0.1, 0.25, 1.0, 1e9}) {
      Correspondences expected;
      for (const Eigen::Vector3d& d : data_) {
        const Neighbor nearest = NearestOfAll(model_, T.RotationMatrix() * d + T.translation, gate);
        expected.model_index.push_back(nearest.index);
        expected.squared_distance.push_back(nearest.squared_distance);
      }
      for (const int threads : {1, 2}) {
        const Parallel parallel(threads);
        EXPECT_THAT(FindByKdTree(tree_, data_, T, gate, parallel), SameCorrespondences(expected));
        EXPECT_THAT(FindByBruteForce(model_, data_, T, gate, parallel), SameCorrespondences(expected));
      }
    }
  }
}

TEST(Correspondences, OfCloudsLargerThanABlockAreTheNearest) {
  // The brute-force search walks the model in blocks; here are several, with equally near points in each.
  const std::vector<Eigen::Vector3d> model = ShuffledLattice(11, 0.25, Eigen::Vector3d::Zero(), 3);
  RandomStream stream = NamedStream(1, "correspondences_test/large");
  std::vector<Eigen::Vector3d> data = DrawCloud(stream, 400, 3.0);
  for (std::size_t i = 0; i < 300; ++i) data[i] = model[7 * i];
  const Correspondences pairs = FindByBruteForce(model, data, Pose3(), 0.5, Parallel(2));
  EXPECT_THAT(FindByKdTree(KdTree(model), data, Pose3(), 0.5, Parallel(2)), SameCorrespondences(pairs));
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_EQ(pairs.model_index[i], NearestOfAll(model, data[i], 0.5).index);
  }
}

TEST(Correspondences, OfNothingAreNone) {
  const std::vector<Eigen::Vector3d> points = {{1.0, 2.0, 3.0}};
  EXPECT_TRUE(FindByBruteForce(points, {}, Pose3(), 1.0, Parallel(1)).model_index.empty());
  EXPECT_TRUE(FindByKdTree(KdTree(points), {}, Pose3(), 1.0, Parallel(1)).model_index.empty());
  EXPECT_EQ(FindByBruteForce({}, points, Pose3(), 1.0, Parallel(1)).model_index.at(0), kNoPoint);
}

}  // namespace
}  // namespace ariadne::slam
