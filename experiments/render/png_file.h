#pragma once

#include <filesystem>

#include "experiments/render/image.h"

namespace ariadne::experiments {

/// Writes a picture; the same picture gives the same bytes (no date, no name of a program).
/// An Error names the file where it cannot be written completely, e.g. because the disk is full.
void WritePng(const std::filesystem::path& path, const Image& image);

/// Reads a PNG of any kind as 8-bit sRGB; transparent parts are shown on white.
Image ReadPng(const std::filesystem::path& path);

}  // namespace ariadne::experiments
