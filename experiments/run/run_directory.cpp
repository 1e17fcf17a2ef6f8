#include "experiments/run/run_directory.h"

#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "slam/base/error.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kProgress = "progress.json";

void MakeDirectory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) Fail("{}: cannot make the directory: {}", path.string(), error.message());
}

bool IsEmptyOrMissing(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return true;
  return std::filesystem::is_directory(path, error) && std::filesystem::is_empty(path, error);
}

/// What a killed run was writing (slam/io/file.h).
void RemovePartialFiles(const std::filesystem::path& path) {
  std::vector<std::filesystem::path> partial;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    if (entry.is_regular_file() && entry.path().extension() == ".partial") partial.push_back(entry.path());
  }
  for (const std::filesystem::path& file : partial) std::filesystem::remove(file);
}

}  // namespace

bool HoldsRun(const std::filesystem::path& path) { return std::filesystem::exists(path / kProgress); }

RunDirectory::RunDirectory(const std::filesystem::path& path, Existing existing) : path_(path) {
  if (existing == Existing::kResume && !HoldsRun(path)) {
    Fail("{}: there is no run to resume (no {})", path.string(), kProgress);
  }
  if (!IsEmptyOrMissing(path) && !HoldsRun(path)) {
    Fail("{}: exists and is not a run directory; choose another --out", path.string());
  }
  if (HoldsRun(path) && existing == Existing::kRefuse) {
    Fail("{}: holds a run already; choose another --out, or add --overwrite or --resume", path.string());
  }
  if (existing == Existing::kOverwrite) std::filesystem::remove_all(path);
  MakeDirectory(path);
  if (existing == Existing::kResume) {
    RemovePartialFiles(path);
  } else {
    WriteProgress("running", 0, 0);  // from now on this is a run directory
  }
}

std::filesystem::path RunDirectory::File(const std::string& name) const {
  std::filesystem::path file = path_ / name;
  MakeDirectory(file.parent_path());
  return file;
}

void RunDirectory::WriteText(const std::string& name, const std::string& text) const {
  slam::WriteFileAtomically(File(name), [&](std::ostream& out) { out << text; });
}

void RunDirectory::WriteJson(const std::string& name, const Json& json) const {
  WriteText(name, json.dump(2) + "\n");
}

void RunDirectory::WriteCsv(const std::string& name, const Table& table) const {
  WriteText(name, ToCsv(table));
}

std::string RunDirectory::ReadText(const std::string& name) const {
  std::ifstream in = slam::OpenForReading(path_ / name);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void RunDirectory::WriteConfig(const std::string& text) const {
  constexpr const char* kConfig = "config.yaml";
  if (std::filesystem::exists(path_ / kConfig) && ReadText(kConfig) != text) {
    Fail("{}: the run to resume had other options; resume it with its own config.yaml, or --overwrite it",
         path_.string());
  }
  WriteText(kConfig, text);
}

void RunDirectory::WriteProgress(const std::string& state, std::size_t done, std::size_t total) const {
  WriteJson(kProgress, {{"state", state}, {"done", done}, {"total", total}});
}

void RunDirectory::NoteFailure(const std::string& sentence) const {
  try {
    Json progress = Json::parse(ReadText(kProgress));
    progress["state"] = "failed";
    progress["error"] = sentence;
    WriteJson(kProgress, progress);
  } catch (const std::exception&) {
    return;  // a full disk, say: what has failed first is what the user must see
  }
}

}  // namespace ariadne::experiments
