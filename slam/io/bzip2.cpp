#include "slam/io/bzip2.h"

#include <bzlib.h>

#include <array>
#include <streambuf>
#include <string_view>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

using traits = std::char_traits<char>;

class Bzip2Buffer : public std::streambuf {
 public:
  Bzip2Buffer(std::istream& file, std::string name) : in_(file), name_(std::move(name)) { Start(); }
  ~Bzip2Buffer() override { BZ2_bzDecompressEnd(&stream_); }
  Bzip2Buffer(const Bzip2Buffer&) = delete;
  Bzip2Buffer& operator=(const Bzip2Buffer&) = delete;

 private:
  int_type underflow() override {
    stream_.next_out = text_.data();
    stream_.avail_out = static_cast<unsigned>(text_.size());
    // Until there is some text: a piece of the file may decompress to nothing yet.
    while (stream_.avail_out == text_.size()) {
      if (stream_.avail_in == 0 && !Refill()) {
        if (in_the_middle_) Fail("{}: the compressed file is truncated; fetch it again", name_);
        return traits_type::eof();
      }
      Decompress();
    }
    setg(text_.data(), text_.data(), text_.data() + (text_.size() - stream_.avail_out));
    return traits_type::to_int_type(text_.front());
  }

  void Decompress() {
    if (!in_the_middle_) {  // the file before has ended, and more follows
      BZ2_bzDecompressEnd(&stream_);
      Start();
      in_the_middle_ = true;
    }
    const int result = BZ2_bzDecompress(&stream_);
    if (result == BZ_STREAM_END) {
      in_the_middle_ = false;
    } else if (result == BZ_MEM_ERROR) {
      Fail("{}: there is not enough memory to decompress it", name_);
    } else if (result != BZ_OK) {
      Fail("{}: the compressed data is damaged; fetch the file again", name_);
    }
  }

  bool Refill() {
    in_.read(file_.data(), static_cast<std::streamsize>(file_.size()));
    if (in_.bad()) Fail("{}: the system cannot read on; check the disk", name_);
    stream_.next_in = file_.data();
    stream_.avail_in = static_cast<unsigned>(in_.gcount());
    return stream_.avail_in > 0;
  }

  /// Keeps what is read of the file, but not yet decompressed.
  void Start() {
    constexpr int kSilent = 0;
    constexpr int kFast = 0;
    if (BZ2_bzDecompressInit(&stream_, kSilent, kFast) != BZ_OK) {
      Fail("{}: there is not enough memory to decompress it", name_);
    }
  }

  std::istream& in_;  // the compressed file
  std::string name_;
  bz_stream stream_{};
  bool in_the_middle_ = true;  // of a file; an empty one is truncated
  std::array<char, 1 << 14> file_;
  std::array<char, 1 << 16> text_;
};

class Bzip2Stream : public std::istream {
 public:
  Bzip2Stream(std::istream& file, const std::string& name) : std::istream(nullptr), buffer_(file, name) {
    rdbuf(&buffer_);
    exceptions(badbit);  // lets the Error of the buffer through
  }

 private:
  Bzip2Buffer buffer_;
};

}  // namespace

bool IsBzip2(std::istream& in) {
  // Read and put back, for a pipe cannot be rewound.
  constexpr std::string_view kMagic = "BZh";
  std::size_t matching = 0;
  while (matching < kMagic.size() && in.peek() == traits::to_int_type(kMagic[matching])) {
    in.get();
    ++matching;
  }
  in.clear();
  for (std::size_t i = 0; i < matching; ++i) in.unget();
  return matching == kMagic.size();
}

std::unique_ptr<std::istream> DecompressBzip2(std::istream& in, const std::string& name) {
  return std::make_unique<Bzip2Stream>(in, name);
}

}  // namespace ariadne::slam
