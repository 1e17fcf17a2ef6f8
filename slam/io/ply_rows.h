#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "slam/io/ply_header.h"
#include "slam/io/row_parser.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// Reads an element of a PLY file record by record, whatever its format and properties.
class PlyRowReader {
 public:
  PlyRowReader(StreamReader& reader, PlyFormat format, const PlyElement& element)
      : reader_(reader), format_(format), element_(element), parser_(reader) {}

  /// The values of the properties, valid until the next call; a list stands as its length. Error with line
  /// or byte where the file ends or the record does not have the announced form.
  std::span<const double> Next();

 private:
  void ReadTextRow();
  void ReadBinaryRow();
  double ReadScalar(ScalarType type);
  std::uint64_t CheckedLength(double length) const;
  [[noreturn]] void FailHere(std::string_view problem) const;

  StreamReader& reader_;
  PlyFormat format_;
  const PlyElement& element_;
  RowParser parser_;
  std::vector<double> row_;
  std::uint64_t rows_ = 0;
};

/// The least that a record can take in the file. [B]
std::uint64_t SmallestRecord(PlyFormat format, const PlyElement& element);

}  // namespace ariadne::slam
