#pragma once

#include <string>
#include <vector>

#include "experiments/report/table.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/graph_minima.h"
#include "slam/graph/optimize/covariance.h"

namespace ariadne::experiments {

/// A row per edge: its line, vertices and kind, its squared error at the file's guess and at the minimum
/// (by the information of the minimum's own objective), and its weight, which is 1 without a robust kernel.
template <typename Pose>
Table EdgeTable(const slam::G2oFile& file, const slam::PoseGraph<Pose>& guess,
                const slam::OptimizeResult<Pose>& minimum);

/// The rows of an EdgeTable with the largest squared errors at the minimum times weight, in falling order.
Table WorstEdges(const Table& edges, std::size_t count);

/// A row per step of each descent.
template <typename Pose>
Table IterationTable(const GraphMinima<Pose>& minima);

/// A row per vertex: standard deviations in the frame of the vertex. [m, rad]
template <typename Pose>
Table SigmaTable(const slam::PoseGraph<Pose>& graph, const slam::GraphCovariances<Pose>& covariances);

/// A row per minimum: costs, iterations and how it ended.
template <typename Pose>
Table MinimaTable(const GraphMinima<Pose>& minima);

/// The results in numbers, without times; and the times.
template <typename Pose>
Json MetricsOf(const slam::G2oFile& file, const slam::PoseGraph<Pose>& graph,
               const GraphMinima<Pose>& minima);
template <typename Pose>
Json TimesOf(const GraphMinima<Pose>& minima);

/// A row per phase, from TimesOf().
Table TimeTable(const Json& times);

std::string_view VerdictOf(const slam::Certificate& certificate);

/// Of edges of a minimum: those that the robust kernel has turned off, more off than on.
std::vector<std::size_t> RejectedEdges(const std::vector<double>& edge_weights);

}  // namespace ariadne::experiments
