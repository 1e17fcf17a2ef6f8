#include "experiments/render/png_file.h"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

static_assert(sizeof(Rgb) == 3, "libpng reads the pixels as rows of r, g, b");

std::string LastSystemError() { return std::generic_category().message(errno); }

/// Frees what libpng holds for a picture on every way out.
struct PngImage : png_image {
  PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(this); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

std::vector<unsigned char> Encoded(const std::filesystem::path& path, const Image& image) {
  PngImage png;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<unsigned char> bytes(size);
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr)) {
    Fail("{}: the picture cannot be encoded: {}", path.string(), png.message);
  }
  bytes.resize(size);
  return bytes;
}

/// libpng's own writing to a file would delete the file where the disk is full, whatever it is (it may be
/// a device or a link); so the bytes are made in memory and written here.
void WriteBytes(const std::filesystem::path& path, const std::vector<unsigned char>& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) Fail("{}: cannot be opened for writing: {}", path.string(), LastSystemError());
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const bool flushed = written && std::fflush(file) == 0;
  const std::string reason = LastSystemError();
  const bool closed = std::fclose(file) == 0;
  if (!flushed) Fail("{}: cannot be written: {}", path.string(), reason);
  if (!closed) Fail("{}: cannot be written: {}", path.string(), LastSystemError());
}

}  // namespace

void WritePng(const std::filesystem::path& path, const Image& image) {
  if (image.pixels.empty()) Fail("{}: the picture to be written has no pixels", path.string());
  WriteBytes(path, Encoded(path, image));
}

Image ReadPng(const std::filesystem::path& path) {
  PngImage png;
  if (!png_image_begin_read_from_file(&png, path.c_str())) {
    Fail("{}: cannot be read as PNG: {}", path.string(), png.message);
  }
  png.format = PNG_FORMAT_RGB;
  if (png.width > 32768 || png.height > 32768) {
    Fail("{}: a picture of {} x {} pixels is too large", path.string(), png.width, png.height);
  }
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  const png_color white{255, 255, 255};
  if (!png_image_finish_read(&png, &white, image.pixels.data(), 0, nullptr)) {
    Fail("{}: cannot be read as PNG: {}", path.string(), png.message);
  }
  return image;
}

}  // namespace ariadne::experiments
