#pragma once

#include <gtest/gtest.h>

#include "slam/registration/align.h"

namespace ariadne::slam {

/// Every number of two results is the same to the last bit.
inline void ExpectSameBytes(const AlignResult& actual, const AlignResult& expected) {
  EXPECT_EQ(actual.status, expected.status);
  EXPECT_EQ(actual.message, expected.message);
  EXPECT_EQ(actual.T_model_data.rotation.coeffs(), expected.T_model_data.rotation.coeffs());
  EXPECT_EQ(actual.T_model_data.translation, expected.T_model_data.translation);
  EXPECT_EQ(actual.pairs, expected.pairs);
  EXPECT_EQ(actual.rms, expected.rms);
  EXPECT_EQ(actual.overlap, expected.overlap);
  ASSERT_EQ(actual.iterations.size(), expected.iterations.size());
  for (std::size_t k = 0; k < expected.iterations.size(); ++k) {
    EXPECT_EQ(actual.iterations[k].pairs, expected.iterations[k].pairs) << k;
    EXPECT_EQ(actual.iterations[k].rms, expected.iterations[k].rms) << k;
    EXPECT_EQ(actual.iterations[k].step_translation, expected.iterations[k].step_translation) << k;
  }
  ASSERT_EQ(actual.assessment.has_value(), expected.assessment.has_value());
  if (!expected.assessment) return;
  EXPECT_EQ(actual.assessment->covariance, expected.assessment->covariance);
  EXPECT_EQ(actual.assessment->observability.shares, expected.assessment->observability.shares);
}

}  // namespace ariadne::slam
