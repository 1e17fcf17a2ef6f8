#include "slam/io/scan_list.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Cuts the digits, or what is not a digit, off the front.
std::string_view CutRun(std::string_view& text) {
  const bool digits = IsDigit(text.front());
  std::size_t length = 1;
  while (length < text.size() && IsDigit(text[length]) == digits) ++length;
  const std::string_view run = text.substr(0, length);
  text.remove_prefix(length);
  return run;
}

/// Negative, 0 or positive, as the number a is less than, equal to or greater than b.
int CompareNumbers(std::string_view a, std::string_view b) {
  const auto without_zeros = [](std::string_view n) {
    return n.substr(std::min(n.find_first_not_of('0'), n.size()));
  };
  const std::string_view digits_a = without_zeros(a);
  const std::string_view digits_b = without_zeros(b);
  if (digits_a.size() != digits_b.size()) return digits_a.size() < digits_b.size() ? -1 : 1;
  return digits_a.compare(digits_b);
}

std::optional<CloudFormat> FormatOfScan(const fs::path& path) {
  const std::string stem = path.stem().string();
  if (stem.starts_with('.')) return std::nullopt;  // "._scan000.3d" is what macOS leaves on other disks
  const bool numbered = !stem.empty() && IsDigit(stem.back());
  if (path.extension() == ".txt" && !numbered) return std::nullopt;
  return FormatFromExtension(path);
}

/// What of the folder itself is a scan.
std::vector<std::pair<CloudFormat, ScanFile>> ScansIn(const fs::path& folder) {
  std::vector<std::pair<CloudFormat, ScanFile>> scans;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) Fail("{}: the folder cannot be read: {}", folder.string(), error.message());
  for (const fs::directory_entry& entry : entries) {
    const std::optional<CloudFormat> format = FormatOfScan(entry.path());
    if (!format || !entry.is_regular_file(error)) continue;
    scans.push_back({*format, {entry.path().stem().string(), entry.path()}});
  }
  return scans;
}

CloudFormat OnlyFormat(const fs::path& folder, const std::vector<std::pair<CloudFormat, ScanFile>>& scans) {
  const CloudFormat first = scans.front().first;
  for (const auto& [format, scan] : scans) {
    if (format == first) continue;
    Fail("{}: holds scans of the formats {} and {}; say which to take with --format", folder.string(),
         NameOf(first), NameOf(format));
  }
  return first;
}

/// The scans of the folder itself, none where it has none of the format.
ScanList ListFolder(const fs::path& folder, std::optional<CloudFormat> format) {
  const auto found = ScansIn(folder);
  ScanList list{folder, format.value_or(CloudFormat::kUos), {}};
  if (found.empty()) return list;
  if (!format) list.format = OnlyFormat(folder, found);
  for (const auto& [scan_format, scan] : found) {
    if (scan_format == list.format) list.scans.push_back(scan);
  }
  const auto before = [](const ScanFile& a, const ScanFile& b) {
    return NaturallyBefore(a.path.filename().string(), b.path.filename().string());
  };
  std::sort(list.scans.begin(), list.scans.end(), before);
  return list;
}

/// The lists of the subfolders that have scans.
std::vector<ScanList> ListSubfolders(const fs::path& folder, std::optional<CloudFormat> format) {
  std::vector<ScanList> lists;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.is_directory()) continue;
    ScanList list = ListFolder(entry.path(), format);
    if (!list.scans.empty()) lists.push_back(std::move(list));
  }
  return lists;
}

}  // namespace

bool NaturallyBefore(std::string_view a, std::string_view b) {
  const std::pair whole(a, b);
  while (!a.empty() && !b.empty()) {
    const std::string_view run_a = CutRun(a);
    const std::string_view run_b = CutRun(b);
    const bool numbers = IsDigit(run_a.front()) && IsDigit(run_b.front());
    const int order = numbers ? CompareNumbers(run_a, run_b) : run_a.compare(run_b);
    if (order != 0) return order < 0;
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole.first < whole.second;  // scan01 and scan1 are different files
}

ScanList ListScans(const fs::path& folder, std::optional<CloudFormat> format) {
  std::error_code ignored;  // not a folder is what counts
  if (!fs::exists(folder, ignored)) Fail("{}: there is no such folder; check the path", folder.string());
  if (!fs::is_directory(folder, ignored)) Fail("{}: is not a folder of scans", folder.string());
  ScanList list = ListFolder(folder, format);
  if (!list.scans.empty()) return list;
  std::vector<ScanList> below = ListSubfolders(folder, format);
  if (below.size() == 1) return std::move(below.front());
  const std::string kind = format ? fmt::format(" of the format {}", NameOf(*format)) : "";
  if (below.empty()) Fail("{}: holds no scans{} (.3d, .xyz, .ply, .pcd, .bin)", folder.string(), kind);
  Fail("{}: holds no scans{}, but {} of its folders do; name one of them", folder.string(), kind,
       below.size());
}

}  // namespace ariadne::slam
