#pragma once

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/report/table.h"

namespace ariadne::experiments {

using Json = nlohmann::ordered_json;  // keys stay in the order in which they are written

/// The directory that a run leaves. Files appear under their names only when they are complete.
class RunDirectory {
 public:
  /// What to do where the directory already holds a run.
  enum class Existing { kRefuse, kOverwrite, kResume };

  /// Makes the directory. Only a directory that is empty or holds a run is ever used; what an overwritten
  /// run has left is removed, and of a resumed one the files that it was writing when it was killed. Error
  /// with a sentence otherwise, or where nothing can be written.
  RunDirectory(const std::filesystem::path& path, Existing existing);

  const std::filesystem::path& path() const { return path_; }

  /// The path of a file in the run; makes the folders above it.
  std::filesystem::path File(const std::string& name) const;

  void WriteText(const std::string& name, const std::string& text) const;
  void WriteJson(const std::string& name, const Json& json) const;
  void WriteCsv(const std::string& name, const Table& table) const;
  std::string ReadText(const std::string& name) const;

  /// config.yaml. Error where the run that is resumed has had other options.
  void WriteConfig(const std::string& text) const;

  /// progress.json: how far the run has come ("running", "finished" or "failed"), for whoever finds it
  /// later.
  void WriteProgress(const std::string& state, std::size_t done, std::size_t total) const;

  /// progress.json says "failed" and why; how far the run has come stays.
  void NoteFailure(const std::string& sentence) const;

 private:
  std::filesystem::path path_;
};

/// True where a directory holds a run: finished, failed or killed.
bool HoldsRun(const std::filesystem::path& path);

/// Does the work of a run. An exception passes on its way out, and the run says that it has failed.
template <typename Work>
auto NotingFailure(const RunDirectory& run, const Work& work) {
  try {
    return work();
  } catch (const std::exception& e) {
    run.NoteFailure(e.what());
    throw;
  }
}

}  // namespace ariadne::experiments
