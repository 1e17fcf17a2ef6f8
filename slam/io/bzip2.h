#pragma once

#include <istream>
#include <memory>
#include <string>

namespace ariadne::slam {

/// Whether the stream, which stays where it is, begins as bzip2 files do.
bool IsBzip2(std::istream& in);

/// What a bzip2 file holds, as a stream that is decompressed while it is read; several files after one
/// another are one text. It cannot be rewound, and reads from `in` as long as it lives. Reading throws an
/// Error with `name` where the file is damaged or ends too early.
std::unique_ptr<std::istream> DecompressBzip2(std::istream& in, const std::string& name);

}  // namespace ariadne::slam
