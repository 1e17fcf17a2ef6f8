#include "experiments/run/manifest.h"

#include <SuiteSparse_config.h>
#include <ariadne_version.h>
#include <ceres/version.h>
#include <dlfcn.h>
#include <openssl/evp.h>
#include <png.h>
#include <tbb/version.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <nanoflann.hpp>

#include "slam/base/error.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

std::string ProcessorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// The file that the calls of BLAS go to, which decides the speed of sparse factorizations and their last
/// digits. Debian exchanges it behind one name, and several may be loaded, of which the first counts.
std::string LoadedBlas() {
  void* const dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  Dl_info info{};
  if (dgemm == nullptr || dladdr(dgemm, &info) == 0) return "none";
  std::error_code ignored;  // then the name is all that is known
  const std::filesystem::path file = std::filesystem::canonical(info.dli_fname, ignored);
  return ignored ? info.dli_fname : file.string();
}

Json Libraries() {
  return {{"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"ceres", CERES_VERSION_STRING},
          {"suitesparse", fmt::format("{}.{}.{}", SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION,
                                      SUITESPARSE_SUBSUB_VERSION)},
          {"blas", LoadedBlas()},
          {"nanoflann", fmt::format("{:x}", NANOFLANN_VERSION)},
          {"tbb", TBB_VERSION_STRING},
          {"fmt", FMT_VERSION},
          {"png", PNG_LIBPNG_VER_STRING}};
}

}  // namespace

std::string Sha256OfFile(const std::filesystem::path& path) {
  std::ifstream in = slam::OpenForReading(path);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr);
  std::vector<char> buffer(1 << 20);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0) {
    EVP_DigestUpdate(context.get(), buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(context.get(), digest.data(), &size);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

Json MakeManifest(const std::vector<std::filesystem::path>& inputs) {
  Json files = Json::object();
  for (const std::filesystem::path& input : inputs) files[input.filename().string()] = Sha256OfFile(input);
  return {{"commit", kCommit},
          {"dirty", kDirty},
          {"compiler", __VERSION__},
          {"libraries", Libraries()},
          {"processor", ProcessorName()},
          {"inputs", files}};
}

void WriteManifest(const RunDirectory& run, const std::vector<std::filesystem::path>& inputs,
                   std::size_t used) {
  constexpr const char* kManifest = "manifest.json";
  const Json manifest = MakeManifest(inputs);
  const bool resumed = used > 0 && std::filesystem::exists(run.path() / kManifest);
  const Json before = resumed ? Json::parse(run.ReadText(kManifest)).at("inputs") : Json::object();
  for (std::size_t i = 0; resumed && i < std::min(used, inputs.size()); ++i) {
    const std::string name = inputs[i].filename().string();
    if (before.value(name, "") == manifest.at("inputs").at(name)) continue;
    Fail("{}: has changed since the run used it; start again with --overwrite", inputs[i].string());
  }
  run.WriteJson(kManifest, manifest);
}

}  // namespace ariadne::experiments
