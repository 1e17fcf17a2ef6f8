#include "slam/sparse/block_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "slam/base/random.h"
#include "slam/sparse/selected_inverse.h"

namespace ariadne::slam {
namespace {

/// A random sparse positive definite matrix of blocks, stored both ways.
struct Sample {
  BlockMatrix sparse;
  Eigen::MatrixXd dense;  // in the order of elimination
};

template <int kSize>
Sample MakeSample(std::size_t blocks, std::size_t edges, std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "sample");
  std::vector<BlockPlace> places;
  for (std::size_t k = 0; k < edges; ++k) {
    const std::size_t i = stream() % blocks, j = stream() % blocks;
    if (i != j) places.emplace_back(i, j);
  }
  Sample sample{BlockMatrix(kSize, OrderBlocks(blocks, places), places), {}};
  sample.dense.setZero(sample.sparse.size(), sample.sparse.size());
  const auto add = [&](std::size_t i, std::size_t j, const Eigen::Matrix<double, kSize, kSize>& block) {
    sample.sparse.Add(sample.sparse.Find(i, j), block);
    sample.dense.block<kSize, kSize>(sample.sparse.row(i), sample.sparse.row(j)) += block;
    if (i != j)
      sample.dense.block<kSize, kSize>(sample.sparse.row(j), sample.sparse.row(i)) += block.transpose();
  };
  const auto random = [&] {
    Eigen::Matrix<double, 2 * kSize, 2 * kSize> a;
    for (double& value : a.reshaped()) value = DrawNormal(stream, 0.0, 1.0);
    return a;
  };
  for (const auto& [i, j] : places) {
    const auto a = random();
    const Eigen::Matrix<double, 2 * kSize, 2 * kSize> h = a * a.transpose();
    add(i, i, h.template topLeftCorner<kSize, kSize>());
    add(j, j, h.template bottomRightCorner<kSize, kSize>());
    add(i, j, h.template topRightCorner<kSize, kSize>());
  }
  for (std::size_t i = 0; i < blocks; ++i) add(i, i, Eigen::Matrix<double, kSize, kSize>::Identity());
  return sample;
}

TEST(BlockCholesky, SolvesWhatADenseFactorSolves) {
  for (const FactorKind kind : {FactorKind::kBest, FactorKind::kSupernodal}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Sample sample = MakeSample<3>(40, 70 * seed, seed);
      BlockCholesky factor(sample.sparse, kind);
      ASSERT_TRUE(factor.Factorize(sample.sparse));
      const Eigen::MatrixXd b = Eigen::MatrixXd::Random(sample.sparse.size(), 2);
      const Eigen::MatrixXd expected = sample.dense.llt().solve(b);
      EXPECT_LT((factor.Solve(b) - expected).norm(), 1e-9 * expected.norm());
    }
  }
}

TEST(BlockCholesky, RefusesAnIndefiniteMatrix) {
  for (const FactorKind kind : {FactorKind::kBest, FactorKind::kSupernodal}) {
    Sample sample = MakeSample<3>(30, 60, 5);
    const double least = sample.dense.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
    BlockCholesky factor(sample.sparse, kind);
    const Eigen::VectorXd shift = Eigen::VectorXd::Constant(sample.sparse.size(), -least - 1e-3);
    sample.sparse.AddToDiagonal(shift);
    EXPECT_FALSE(factor.Factorize(sample.sparse));
    sample.sparse.AddToDiagonal(Eigen::VectorXd::Constant(sample.sparse.size(), 2e-3));
    EXPECT_TRUE(factor.Factorize(sample.sparse));
  }
}

TEST(SelectedInverse, IsTheDiagonalOfTheDenseInverse) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Sample sample = MakeSample<3>(10 * seed, 20 * seed, seed);
    BlockCholesky factor(sample.sparse, FactorKind::kSupernodal);
    ASSERT_TRUE(factor.Factorize(sample.sparse));
    const std::vector<Eigen::MatrixXd> blocks = DiagonalBlocksOfInverse(factor, sample.sparse);
    const Eigen::MatrixXd inverse = sample.dense.inverse();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Eigen::Index row = sample.sparse.row(i);
      EXPECT_LT((blocks[i] - inverse.block(row, row, 3, 3)).norm(), 1e-9 * inverse.norm());
    }
  }
}

TEST(BlockMatrix, KeepsItsDiagonal) {
  const Sample sample = MakeSample<2>(25, 50, 7);
  EXPECT_EQ(sample.sparse.DiagonalEntries(), sample.dense.diagonal());
}

}  // namespace
}  // namespace ariadne::slam
