#include "slam/graph/simulated_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/base/random.h"
#include "slam/graph/structure.h"

namespace ariadne::slam {
namespace {

constexpr double kStep = 1.0;          // [m]
constexpr double kSeenWithin = 1.2;    // places as near as this overlap [m]
constexpr std::size_t kNotBefore = 5;  // steps between a place and the same place again

template <typename Pose>
typename Pose::Tangent Noise(const SimulatedGraphOptions& options, RandomStream& stream) {
  constexpr int d = Pose::Point::RowsAtCompileTime;
  typename Pose::Tangent tau;
  for (int k = 0; k < Pose::kDof; ++k)
    tau[k] = DrawNormal(stream, 0.0, k < d ? options.translation_noise : options.rotation_noise);
  return tau;
}

template <typename Pose>
typename Pose::Square Information(const SimulatedGraphOptions& options) {
  constexpr int d = Pose::Point::RowsAtCompileTime;
  constexpr double kLeast = 1e-6;  // a measurement without noise still has a finite information
  typename Pose::Tangent diagonal;
  for (int k = 0; k < Pose::kDof; ++k) {
    const double sigma = std::max(k < d ? options.translation_noise : options.rotation_noise, kLeast);
    diagonal[k] = 1.0 / (sigma * sigma);
  }
  return diagonal.asDiagonal();
}

/// A quarter turn to the left or the right; in space also up or down.
Pose2 QuarterTurn(const Pose2&, RandomStream& stream) {
  return {DrawUniform(stream, -1.0, 1.0) < 0.0 ? -0.5 * std::numbers::pi : 0.5 * std::numbers::pi,
          Eigen::Vector2d::Zero()};
}
Pose3 QuarterTurn(const Pose3&, RandomStream& stream) {
  const double axis = DrawUniform(stream, 0.0, 1.0), angle = DrawUniform(stream, -1.0, 1.0);
  Pose3::Tangent tau = Pose3::Tangent::Zero();
  tau[axis < 0.8 ? 5 : 4] = angle < 0.0 ? -0.5 * std::numbers::pi : 0.5 * std::numbers::pi;
  return Pose3::Exp(tau);
}

template <typename Pose>
std::vector<Pose> Walk(const SimulatedGraphOptions& options, RandomStream& stream) {
  typename Pose::Tangent ahead = Pose::Tangent::Zero();
  ahead[0] = kStep;
  std::vector<Pose> walk{Pose()};
  // It stays in a square in which it meets its own way again and again.
  const double half_side = 0.35 * std::sqrt(static_cast<double>(options.poses)) + 1.0;
  while (walk.size() < static_cast<std::size_t>(options.poses)) {
    Pose next = walk.back();
    if (DrawUniform(stream, 0.0, 1.0) < options.turn_probability) next = next * QuarterTurn(next, stream);
    while ((next * Pose::Exp(ahead)).translation.template lpNorm<Eigen::Infinity>() > half_side)
      next = next * QuarterTurn(next, stream);
    walk.push_back(next * Pose::Exp(ahead));
  }
  return walk;
}

template <typename Pose>
Pose RandomRelativePose(double reach, RandomStream& stream) {
  typename Pose::Tangent tau;
  constexpr int d = Pose::Point::RowsAtCompileTime;
  for (int k = 0; k < Pose::kDof; ++k)
    tau[k] = k < d ? DrawUniform(stream, -reach, reach) : DrawUniform(stream, -1.5, 1.5);
  return Pose::Exp(tau);
}

/// Pairs of poses that see the same place, in the order of the walk.
template <typename Pose>
std::vector<std::pair<std::size_t, std::size_t>> SeenAgain(const std::vector<Pose>& walk,
                                                           double probability, RandomStream& stream) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t j = kNotBefore; j < walk.size(); ++j) {
    for (std::size_t i = 0; i + kNotBefore <= j; ++i) {
      if ((walk[i].translation - walk[j].translation).norm() > kSeenWithin) continue;
      if (DrawUniform(stream, 0.0, 1.0) < probability) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

}  // namespace

template <typename Pose>
SimulatedGraph<Pose> SimulateGraph(const SimulatedGraphOptions& options, std::uint64_t seed) {
  CheckOptions(options);
  RandomStream walking = NamedStream(seed, "graph/walk"), seeing = NamedStream(seed, "graph/closures"),
               measuring = NamedStream(seed, "graph/noise"), erring = NamedStream(seed, "graph/wrong");
  SimulatedGraph<Pose> simulated;
  simulated.truth = Walk<Pose>(options, walking);
  const auto measure = [&](std::size_t from, std::size_t to, const Pose& T_from_to, bool wrong) {
    const Pose measured = T_from_to * Pose::Exp(Noise<Pose>(options, measuring));
    simulated.graph.edges.push_back({from, to, measured, Information<Pose>(options)});
    simulated.wrong_edge.push_back(wrong);
  };
  for (std::size_t i = 0; i < simulated.truth.size(); ++i) {
    simulated.graph.nodes.push_back({static_cast<std::int64_t>(i), Pose(), i == 0});
    if (i > 0) measure(i - 1, i, simulated.truth[i - 1].Inverse() * simulated.truth[i], false);
  }
  for (const auto& [i, j] : SeenAgain(simulated.truth, options.closure_probability, seeing)) {
    const bool wrong = DrawUniform(erring, 0.0, 1.0) < options.wrong_closures;
    const Pose elsewhere = RandomRelativePose<Pose>(5.0 * kStep, erring);
    measure(i, j, wrong ? elsewhere : simulated.truth[i].Inverse() * simulated.truth[j], wrong);
  }
  PlaceAlongEdges(simulated.graph);
  return simulated;
}

template SimulatedGraph<Pose2> SimulateGraph(const SimulatedGraphOptions&, std::uint64_t);
template SimulatedGraph<Pose3> SimulateGraph(const SimulatedGraphOptions&, std::uint64_t);

}  // namespace ariadne::slam
