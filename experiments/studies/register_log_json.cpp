#include "experiments/studies/register_log.h"

namespace ariadne::experiments {
namespace {

Json ToJson(const Table& table) { return {{"columns", table.columns}, {"rows", table.rows}}; }

Table TableFromJson(const Json& json) {
  return {json.at("columns").get<std::vector<std::string>>(),
          json.at("rows").get<std::vector<std::vector<std::string>>>()};
}

Json ToJson(const slam::Pose3& pose) {
  const Eigen::Quaterniond& q = pose.rotation;
  const Eigen::Vector3d& t = pose.translation;
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

slam::Pose3 PoseFromJson(const Json& json) {
  const auto v = json.get<std::vector<double>>();
  return {Eigen::Quaterniond(v.at(6), v.at(3), v.at(4), v.at(5)), {v.at(0), v.at(1), v.at(2)}};
}

Json ToJson(const slam::ScanGraph& graph) {
  Json nodes = Json::array(), edges = Json::array();
  for (const slam::PoseNode<slam::Pose3>& node : graph.graph.nodes)
    nodes.push_back({{"T_map_node", ToJson(node.T_map_node)}, {"fixed", node.fixed}});
  for (std::size_t k = 0; k < graph.kinds.size(); ++k) {
    const slam::PoseEdge<slam::Pose3>& edge = graph.graph.edges[k];
    edges.push_back(
        {{"from", edge.from},
         {"to", edge.to},
         {"kind", static_cast<int>(graph.kinds[k])},
         {"T_from_to", ToJson(edge.T_from_to)},
         {"information", std::vector<double>(edge.information.data(),
                                             edge.information.data() + edge.information.size())}});
  }
  return {{"nodes", nodes}, {"edges", edges}};
}

slam::ScanGraph GraphFromJson(const Json& json) {
  slam::ScanGraph graph;
  for (const Json& node : json.at("nodes")) {
    const auto id = static_cast<std::int64_t>(graph.graph.nodes.size());
    graph.graph.nodes.push_back({id, PoseFromJson(node.at("T_map_node")), node.at("fixed").get<bool>()});
  }
  for (const Json& json_edge : json.at("edges")) {
    slam::PoseEdge<slam::Pose3> edge{json_edge.at("from"), json_edge.at("to"),
                                     PoseFromJson(json_edge.at("T_from_to"))};
    const auto information = json_edge.at("information").get<std::vector<double>>();
    edge.information = Eigen::Map<const slam::Pose3::Square>(information.data());
    graph.graph.edges.push_back(edge);
    graph.kinds.push_back(static_cast<slam::ScanEdgeKind>(json_edge.at("kind").get<int>()));
  }
  return graph;
}

}  // namespace

Json ToJson(const RegisterLog& log) {
  Json poses = Json::array();
  for (const slam::Pose3& pose : log.T_map_laser) poses.push_back(ToJson(pose));
  return {{"scans", ToJson(log.scans)},
          {"steps", ToJson(log.steps)},
          {"iterations", ToJson(log.iterations)},
          {"covariances", ToJson(log.covariances)},
          {"closures", ToJson(log.closures)},
          {"passes", ToJson(log.passes)},
          {"graph", ToJson(log.graph)},
          {"T_map_laser", poses},
          {"registered", log.registered},
          {"points", log.points},
          {"has_reflectance", log.has_reflectance}};
}

RegisterLog RegisterLogFromJson(const Json& json) {
  RegisterLog log;
  log.scans = TableFromJson(json.at("scans"));
  log.steps = TableFromJson(json.at("steps"));
  log.iterations = TableFromJson(json.at("iterations"));
  log.covariances = TableFromJson(json.at("covariances"));
  log.closures = TableFromJson(json.at("closures"));
  log.passes = TableFromJson(json.at("passes"));
  log.graph = GraphFromJson(json.at("graph"));
  for (const Json& pose : json.at("T_map_laser")) log.T_map_laser.push_back(PoseFromJson(pose));
  log.registered = json.at("registered").get<std::vector<bool>>();
  log.points = json.at("points").get<std::vector<std::size_t>>();
  log.has_reflectance = json.at("has_reflectance").get<bool>();
  return log;
}

}  // namespace ariadne::experiments
