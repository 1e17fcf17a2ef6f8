#include "experiments/bench/bench_data.h"

#include <filesystem>

#include "experiments/studies/scan_pair.h"
#include "slam/base/error.h"
#include "slam/registration/align.h"

namespace ariadne::bench {
namespace {

BenchPair Load(const std::string& name, const std::string& folder) {
  experiments::ScanPairOptions options;
  options.input.folder = folder;
  experiments::ScanPair pair = experiments::ReadScanPair(options);
  const auto reduced = [](const slam::PointCloud& cloud) {
    return slam::ReduceOctree(cloud, 0.2, slam::Representative::kCenter, 0);
  };
  BenchPair loaded{name, std::move(pair.model), std::move(pair.data), {}, {}, pair.T_model_data_guess};
  loaded.model_reduced = reduced(loaded.model);
  loaded.data_reduced = reduced(loaded.data);
  return loaded;
}

}  // namespace

const BenchPair& Pair() {
  static const BenchPair kPair = [] {
    try {
      return Load("hallway", "$ARIADNE_DATA/scans/hallway");
    } catch (const Error&) {
      return Load("built-in office", "builtin:office");
    }
  }();
  return kPair;
}

int Iterations(bool reduced) {
  slam::AlignOptions options;
  options.assess = false;
  const BenchPair& pair = Pair();
  const auto& model = reduced ? pair.model_reduced : pair.model;
  const auto& data = reduced ? pair.data_reduced : pair.data;
  return static_cast<int>(slam::Align(model, data, pair.T_model_data_guess, options).iterations.size());
}

}  // namespace ariadne::bench
