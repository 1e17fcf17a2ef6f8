// ariadne optimize and the benchmark of public graphs, as a user runs them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A square of four poses with a closure, whose measurements nearly agree.
constexpr const char* kSquare =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1.1 0.1 1.5\nVERTEX_SE2 2 1 1 3.1\nVERTEX_SE2 3 0 1.2 -1.5\n"
    "EDGE_SE2 0 1 1 0 1.5707963267948966 50 0 0 50 0 100\n"
    "EDGE_SE2 1 2 1 0 1.5707963267948966 50 0 0 50 0 100\n"
    "EDGE_SE2 2 3 1.05 0.02 1.55 50 0 0 50 0 100\n"
    "EDGE_SE2 3 0 1 0 1.5707963267948966 50 0 0 50 0 100\n";

class OptimizeTest : public ProgramTest {
 protected:
  OptimizeTest() { folder_.Write("square.g2o", kSquare); }
  json Metrics(const std::string& run) const { return json::parse(Content(run + "/metrics.json")); }
  /// The lines of a file that begin so.
  std::string LinesOf(const std::string& file, const std::string& beginning) const {
    std::istringstream in(Content(file));
    std::string found;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with(beginning)) found += line + "\n";
    }
    return found;
  }
};

TEST_F(OptimizeTest, FindsAndCertifiesTheMinimumOfBothObjectives) {
  const std::string out = Must("optimize square.g2o --certify --covariances --out run -q");
  EXPECT_THAT(out, AllOf(HasSubstr("4 vertices, 4 edges, 1 of them closures"), HasSubstr("optimal"),
                         HasSubstr("note: no vertex is fixed: vertex 0 is held")));
  const json metrics = Metrics("run");
  EXPECT_GT(metrics.at("information").at("objective_guess"), 1.0);
  // The third edge alone could take all that the loop misses, 5 cm, 2 cm and 0.02 rad; shared, it costs
  // less.
  EXPECT_LT(metrics.at("information").at("objective"),
            50 * (0.05 * 0.05 + 0.02 * 0.02) + 100 * 0.0208 * 0.0208);
  EXPECT_GT(metrics.at("information").at("objective"), 0.02);
  EXPECT_LT(metrics.at("isotropic").at("objective"),
            50 * (0.05 * 0.05 + 0.02 * 0.02) + 200 * 0.0208 * 0.0208);
  EXPECT_EQ(metrics.at("certificate").at("verdict"), "optimal");
  EXPECT_EQ(LinesOf("run/optimized.g2o", "EDGE"), LinesOf("square.g2o", "EDGE")) << "as in the input";
  EXPECT_THAT(Content("run/covariances.csv"), StartsWith("vertex,x_m,y_m,angle_rad\n0,0,0,0\n1,"));
  EXPECT_THAT(Content("run/manifest.json"), AllOf(HasSubstr("square.g2o"), HasSubstr("\"blas\": \"/")));
  for (const char* file : {"config.yaml", "edges.csv", "iterations.csv", "timing.json", "trajectory.tum",
                           "README.txt", "report.html", "figures/graph.png"}) {
    EXPECT_TRUE(fs::exists(folder_ / "run" / file)) << file;
  }
}

TEST_F(OptimizeTest, GivesTheSameBytesAgain) {
  Must("optimize square.g2o --certify --out a -q");
  Must("run a/config.yaml --out b -q");
  ExpectSameFiles("a", "b");
}

TEST_F(OptimizeTest, RejectsAWrongClosureAndSaysWhich) {
  folder_.Write("wrong.g2o", std::string(kSquare) + "EDGE_SE2 0 2 9 -9 0 50 0 0 50 0 100\n");
  const std::string out = Must("optimize wrong.g2o --robust gnc --out run -q");
  EXPECT_THAT(out, HasSubstr("rejected closures: 1, in lines 9\n"));
  EXPECT_THAT(LinesOf("run/edges.csv", "9,0,2,closure,"), testing::EndsWith(",0\n"));
  Must("optimize wrong.g2o --out bent -q");
  EXPECT_GT(Metrics("bent").at("information").at("objective"), 100.0) << "the closure bends the map";
}

TEST_F(OptimizeTest, OffersTheIsotropicObjectiveWhereTheOtherIsUnbounded) {
  folder_.Write("bad.g2o", std::string(kSquare) + "EDGE_SE2 1 3 -1 1 3.14159 1 0 30 1 0 100\n");
  const std::string out = Must("optimize bad.g2o --out run -q");
  EXPECT_THAT(
      out, HasSubstr("note: bad.g2o:9: the information matrix is not positive definite, as in 1 of the 5 "
                     "edges, so that the file's own objective is unbounded"));
  EXPECT_FALSE(Metrics("run").contains("information"));
  const Ended ended = Ariadne("optimize bad.g2o --objective information --out other -q");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, AllOf(StartsWith("ariadne: bad.g2o:9: "), HasSubstr("choose the isotropic one")));
  EXPECT_FALSE(fs::exists(folder_ / "other"));
}

TEST_F(OptimizeTest, ToldInOneSentenceWhatIsHopeless) {
  folder_.Write("nan.g2o", "VERTEX_SE2 0 nan 0 0\n");
  folder_.Write("pieces.g2o", std::string(kSquare) + "VERTEX_SE2 9 0 0 0\n");
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"optimize nan.g2o", "nan.g2o:1: a number of the VERTEX_SE2 is NaN or infinite"},
      {"optimize pieces.g2o",
       "pieces.g2o:9: no edges lead from vertex 0 to vertex 9, which begins a piece of 1 "},
      {"optimize none.g2o", "none.g2o: there is no such file"},
      {"optimize", "which graph? "},
      {"optimize square.g2o --robust best", "--set graph.robust=best: graph.robust must be one of none, "}};
  for (const auto& [arguments, sentence] : mistakes) {
    const Ended ended = Ariadne(arguments + " --out run -q");
    EXPECT_EQ(ended.status, 1);
    EXPECT_THAT(ended.err, StartsWith("ariadne: " + sentence));
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "run"));
  }
  Must("optimize square.g2o --out run -q");
  EXPECT_THAT(Ariadne("optimize square.g2o --out run -q").err, HasSubstr("holds a run already"));
  Must("optimize square.g2o --out run --overwrite -q");
}

TEST_F(OptimizeTest, ReachesTheKnownOptimaOfPublicGraphs) {
  const fs::path graphs = fs::absolute(slam::testing_support::DataFolder()) / "graphs";
  ARIADNE_REQUIRE_DATA(graphs);
  fs::create_directory(folder_ / "graphs");
  for (const std::string name : {"tinyGrid3D", "smallGrid3D", "intel"}) {
    fs::create_symlink(graphs / (name + ".g2o"), folder_ / "graphs" / (name + ".g2o"));
  }
  const std::string out =
      Must("run '" ARIADNE_SOURCE_DIR
           "/experiments/configs/posegraph_benchmark.yaml' --set folder=graphs --out run -q");
  EXPECT_THAT(out, HasSubstr("intel"));
  const json metrics = Metrics("run");
  ASSERT_EQ(metrics.size(), 3U);
  EXPECT_EQ(metrics[0].at("graph"), "intel");
  EXPECT_NEAR(metrics[0].at("objective"), 52.348227, 52.3e-6);
  EXPECT_NEAR(metrics[0].at("information_objective"), 45.0046958, 45e-6);
  EXPECT_EQ(metrics[1].at("graph"), "smallGrid3D");
  EXPECT_NEAR(metrics[1].at("objective"), 1025.398060, 1025e-6);
  EXPECT_NEAR(metrics[1].at("information_objective"), 458.153784, 458e-6);
  for (const json& graph : metrics) EXPECT_EQ(graph.at("verdict"), "optimal") << graph.at("graph");
}

}  // namespace
}  // namespace ariadne
