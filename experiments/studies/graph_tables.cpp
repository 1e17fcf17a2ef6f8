#include "experiments/studies/graph_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "slam/graph/structure.h"

namespace ariadne::experiments {
namespace {

using slam::Certificate;
using slam::G2oFile;
using slam::OptimizeResult;
using slam::Pose2;
using slam::Pose3;
using slam::PoseGraph;

/// Where EdgeTable() has its numbers.
constexpr std::size_t kErrorColumn = 5;
constexpr std::size_t kWeightColumn = 6;

std::vector<std::string> SigmaColumns(const Pose2*) { return {"vertex", "x_m", "y_m", "angle_rad"}; }
std::vector<std::string> SigmaColumns(const Pose3*) {
  return {"vertex", "x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad"};
}

template <typename Pose>
void AddIterations(Table& table, const char* objective,
                   const std::optional<OptimizeResult<Pose>>& minimum) {
  if (!minimum) return;
  int number = 0;
  for (const slam::GraphIteration& iteration : minimum->iterations) {
    table.rows.push_back({objective, std::to_string(++number), Exact(iteration.objective),
                          Exact(iteration.step), Exact(iteration.damping),
                          std::to_string(iteration.factorizations)});
  }
}

template <typename Pose>
void AddMinimum(Table& table, const char* objective, const std::optional<OptimizeResult<Pose>>& minimum) {
  if (!minimum) return;
  table.rows.push_back({objective, fmt::format("{:.9g}", minimum->objective_guess),
                        fmt::format("{:.9g}", minimum->objective_start),
                        fmt::format("{:.9g}", minimum->objective),
                        std::to_string(minimum->iterations.size()), std::string(Name(minimum->status))});
}

template <typename Pose>
Json ToJson(const OptimizeResult<Pose>& minimum) {
  Json json = {{"status", Name(minimum.status)},
               {"message", minimum.message},
               {"objective_guess", minimum.objective_guess},
               {"objective_start", minimum.objective_start},
               {"objective", minimum.objective},
               {"iterations", minimum.iterations.size()}};
  if (!minimum.edge_weights.empty()) json["rejected"] = RejectedEdges(minimum.edge_weights).size();
  return json;
}

Json ToJson(const Certificate& certificate) {
  return {{"verdict", VerdictOf(certificate)},        {"message", certificate.message},
          {"objective", certificate.objective},       {"lower_bound", certificate.lower_bound},
          {"relative_gap", certificate.relative_gap}, {"least_eigenvalue", certificate.least_eigenvalue}};
}

Json ToJson(const slam::GraphTimes& times) {
  return {{"start", times.start},         {"symbolic", times.symbolic}, {"linearize", times.linearize},
          {"factorize", times.factorize}, {"solve", times.solve},       {"total", times.total}};
}

}  // namespace

std::string_view VerdictOf(const Certificate& certificate) {
  return certificate.verdict == slam::CertificateVerdict::kOptimal ? "optimal" : "not certified";
}

std::vector<std::size_t> RejectedEdges(const std::vector<double>& edge_weights) {
  std::vector<std::size_t> rejected;
  for (std::size_t i = 0; i < edge_weights.size(); ++i) {
    if (edge_weights[i] < 0.5) rejected.push_back(i);
  }
  return rejected;
}

template <typename Pose>
Table EdgeTable(const G2oFile& file, const PoseGraph<Pose>& guess, const OptimizeResult<Pose>& minimum) {
  Table table{{"line", "from", "to", "kind", "squared_error_guess", "squared_error", "weight"}, {}};
  PoseGraph<Pose> before = minimum.graph;
  for (std::size_t i = 0; i < guess.nodes.size(); ++i)
    before.nodes[i].T_map_node = guess.nodes[i].T_map_node;
  for (std::size_t i = 0; i < minimum.graph.edges.size(); ++i) {
    const slam::PoseEdge<Pose>& edge = minimum.graph.edges[i];
    table.rows.push_back({std::to_string(file.edge_lines[i]), std::to_string(guess.nodes[edge.from].id),
                          std::to_string(guess.nodes[edge.to].id), IsClosure(edge) ? "closure" : "odometry",
                          Exact(SquaredError(before, edge)), Exact(SquaredError(minimum.graph, edge)),
                          Exact(minimum.edge_weights.empty() ? 1.0 : minimum.edge_weights[i])});
  }
  return table;
}

Table WorstEdges(const Table& edges, std::size_t count) {
  std::vector<std::size_t> order(edges.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto badness = [&](std::size_t row) {
    return std::stod(edges.rows[row][kErrorColumn]) * std::stod(edges.rows[row][kWeightColumn]);
  };
  std::ranges::stable_sort(order, std::greater(), badness);
  order.resize(std::min(count, order.size()));
  Table worst{edges.columns, {}};
  for (const std::size_t row : order) {
    worst.rows.push_back(edges.rows[row]);
    for (std::size_t column = 4; column <= kWeightColumn; ++column) {
      worst.rows.back()[column] = fmt::format("{:.5g}", std::stod(edges.rows[row][column]));
    }
  }
  return worst;
}

template <typename Pose>
Table IterationTable(const GraphMinima<Pose>& minima) {
  Table table{{"objective", "iteration", "value", "step", "damping", "factorizations"}, {}};
  AddIterations(table, "isotropic", minima.isotropic);
  AddIterations(table, "information", minima.information);
  return table;
}

template <typename Pose>
Table SigmaTable(const PoseGraph<Pose>& graph, const slam::GraphCovariances<Pose>& covariances) {
  Table table{SigmaColumns(static_cast<Pose*>(nullptr)), {}};
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    std::vector<std::string> row{std::to_string(graph.nodes[i].id)};
    for (const double variance : covariances.nodes[i].diagonal()) row.push_back(Exact(std::sqrt(variance)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

template <typename Pose>
Table MinimaTable(const GraphMinima<Pose>& minima) {
  Table table{{"objective", "at the guess", "at the start", "at the end", "iterations", "status"}, {}};
  AddMinimum(table, "isotropic", minima.isotropic);
  AddMinimum(table, "information", minima.information);
  return table;
}

template <typename Pose>
Json MetricsOf(const G2oFile& file, const PoseGraph<Pose>& graph, const GraphMinima<Pose>& minima) {
  const auto closures = std::ranges::count_if(graph.edges, slam::IsClosure<Pose>);
  Json json = {{"dimension", Pose::Point::RowsAtCompileTime},
               {"vertices", graph.nodes.size()},
               {"edges", graph.edges.size()},
               {"closures", closures},
               {"priors", graph.priors.size()},
               {"edges_without_definite_information", slam::IndefiniteEdges(graph).size()}};
  if (minima.isotropic) json["isotropic"] = ToJson(*minima.isotropic);
  if (minima.information) json["information"] = ToJson(*minima.information);
  if (minima.certificate) json["certificate"] = ToJson(*minima.certificate);
  json["notes"] = file.notes;
  for (const std::string& note : minima.notes) json["notes"].push_back(note);
  return json;
}

template <typename Pose>
Json TimesOf(const GraphMinima<Pose>& minima) {
  Json json = Json::object();
  if (minima.isotropic) json["isotropic_s"] = ToJson(minima.isotropic->times);
  if (minima.information) json["information_s"] = ToJson(minima.information->times);
  if (minima.certificate) json["certificate_s"] = minima.certificate->seconds;
  return json;
}

Table TimeTable(const Json& times) {
  Table table{{"phase", "ms"}, {}};
  const nlohmann::ordered_json flat = times.flatten();
  for (const auto& [name, seconds] : flat.items()) {
    std::string phase = name.substr(1);
    if (const std::size_t unit = phase.find("_s"); unit != std::string::npos) phase.erase(unit, 2);
    std::ranges::replace(phase, '/', ' ');
    table.rows.push_back({phase, fmt::format("{:.2f}", 1e3 * seconds.template get<double>())});
  }
  return table;
}

template Table EdgeTable(const G2oFile&, const PoseGraph<Pose2>&, const OptimizeResult<Pose2>&);
template Table IterationTable(const GraphMinima<Pose2>&);
template Table SigmaTable(const PoseGraph<Pose2>&, const slam::GraphCovariances<Pose2>&);
template Table MinimaTable(const GraphMinima<Pose2>&);
template Json MetricsOf(const G2oFile&, const PoseGraph<Pose2>&, const GraphMinima<Pose2>&);
template Json TimesOf(const GraphMinima<Pose2>&);
template Table EdgeTable(const G2oFile&, const PoseGraph<Pose3>&, const OptimizeResult<Pose3>&);
template Table IterationTable(const GraphMinima<Pose3>&);
template Table SigmaTable(const PoseGraph<Pose3>&, const slam::GraphCovariances<Pose3>&);
template Table MinimaTable(const GraphMinima<Pose3>&);
template Json MetricsOf(const G2oFile&, const PoseGraph<Pose3>&, const GraphMinima<Pose3>&);
template Json TimesOf(const GraphMinima<Pose3>&);

}  // namespace ariadne::experiments
