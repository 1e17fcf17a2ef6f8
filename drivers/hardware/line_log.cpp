#include "drivers/hardware/line_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;

Bytes ContentOfFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) Fail("{}: cannot be read; there is no such log", path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::unique_ptr<LineLogDecoder> DecoderOf(ByteView content, const fs::path& path) {
  try {
    return std::make_unique<LineLogDecoder>(content);
  } catch (const Error& error) {
    Fail("{}: {}", path.string(), error.what());
  }
}

/// The log of a file `name.000`; none for other names.
std::optional<fs::path> LogOfFile(const fs::path& file) {
  const std::string number = file.extension().string();
  const bool digits = number.size() >= 4 && std::all_of(number.begin() + 1, number.end(),
                                                        [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return std::nullopt;
  return fs::path(file).replace_extension();
}

bool BeginsLikeALog(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  char magic[8] = {};
  in.read(magic, sizeof magic);
  return std::string_view(magic, 7) == "ARIADLN";
}

}  // namespace

fs::path LineLogFile(const fs::path& name, int number) {
  return fmt::format("{}.{:03}", name.string(), number);
}

LineLogWriter::LineLogWriter(fs::path name, std::uintmax_t max_file_size)
    : name_(std::move(name)), max_file_size_(max_file_size) {
  if (fs::exists(LineLogFile(name_, 0)))
    Fail("there is a log {} already; give the new one another name", name_.string());
  Open();
}

void LineLogWriter::Open() {
  const fs::path path = LineLogFile(name_, files_++);
  file_.reset(std::fopen(path.c_str(), "wbx"));
  if (file_ == nullptr) Fail("{}: cannot be written: {}", path.string(), std::strerror(errno));
  size_ = 0;
  Put(encoder_.Begin());
}

void LineLogWriter::Put(ByteView bytes) {
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
  if (!written || std::fflush(file_.get()) != 0) {
    Fail("{}: cannot be written: {}; make room on the disk", LineLogFile(name_, files_ - 1).string(),
         std::strerror(errno));
  }
  size_ += bytes.size();
}

void LineLogWriter::Add(std::uint8_t line, const LineRecord& record) {
  if (failed_) Fail("{}: could not be written before; the log ends there", name_.string());
  failed_ = true;  // until it is done: behind half a record nothing could be read
  Bytes bytes = encoder_.Add({line, record});
  const bool begun = size_ > LineLogEncoder::kHeadSize;
  if (begun && size_ + bytes.size() > max_file_size_) {
    Open();
    bytes = encoder_.Add({line, record});
  }
  Put(bytes);
  last_time_ = record.time;
  failed_ = false;
}

void LineLogWriter::Note(std::string_view text) {
  Add(kNotesLine, {LineRecord::Kind::kNote, last_time_, Bytes(text.begin(), text.end())});
}

LineLogReader::LineLogReader(fs::path name) : name_(std::move(name)) { Open(); }

void LineLogReader::Open() {
  const fs::path path = LineLogFile(name_, log_.files);
  content_ = ContentOfFile(path);
  decoder_ = DecoderOf(content_, path);
}

void LineLogReader::Close() {
  const bool last = !fs::exists(LineLogFile(name_, log_.files + 1));
  log_.size += content_.size();
  log_.torn = content_.size() - decoder_->position();
  if (log_.torn > 0 && !last) {
    Fail("{}: is damaged at byte {}", LineLogFile(name_, log_.files).string(), decoder_->position());
  }
  ++log_.files;
  decoder_.reset();
  if (!last) Open();
}

std::optional<LoggedRecord> LineLogReader::Next() {
  for (; decoder_; Close()) {
    if (std::optional<LoggedRecord> logged = decoder_->Next()) {
      ++log_.records;
      return logged;
    }
  }
  return std::nullopt;
}

LineLogFiles VisitLineLog(const fs::path& name, const std::function<void(const LoggedRecord&)>& visit) {
  LineLogReader reader(name);
  while (const std::optional<LoggedRecord> logged = reader.Next()) visit(*logged);
  return reader.files();
}

std::map<std::uint8_t, std::vector<LineRecord>> ReadLineLog(const fs::path& name) {
  std::map<std::uint8_t, std::vector<LineRecord>> lines;
  VisitLineLog(name, [&](const LoggedRecord& logged) { lines[logged.line].push_back(logged.record); });
  return lines;
}

std::vector<fs::path> FindLineLogs(const fs::path& path) {
  if (fs::exists(LineLogFile(path, 0))) return {path};
  if (fs::is_regular_file(path)) {
    if (const std::optional<fs::path> name = LogOfFile(path); name && BeginsLikeALog(path)) return {*name};
    Fail("{}: is no log of lines; its files are named NAME.000, NAME.001 ...", path.string());
  }
  if (!fs::is_directory(path)) Fail("{}: there is no such log or folder; check the path", path.string());
  std::set<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    const std::optional<fs::path> name = entry.is_regular_file() ? LogOfFile(entry.path()) : std::nullopt;
    if (name && BeginsLikeALog(entry.path())) names.insert(*name);
  }
  if (names.empty()) Fail("{}: holds no logs of lines (NAME.000 ...)", path.string());
  return {names.begin(), names.end()};
}

}  // namespace ariadne::drivers
