#pragma once

#include <vector>

#include "slam/io/pcd_header.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// Reads the data of a binary_compressed PCD file: the fields of all points, one field after the other. The
/// whole block is in memory, since LZF cannot be decompressed in pieces. Error with the byte where its
/// sizes contradict the header or each other, or its bytes are damaged; no memory is taken on their word
/// alone.
std::vector<char> ReadCompressedFields(StreamReader& reader, const PcdHeader& header);

}  // namespace ariadne::slam
