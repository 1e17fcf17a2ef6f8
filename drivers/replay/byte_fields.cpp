#include "drivers/replay/byte_fields.h"

namespace ariadne::drivers {

void FieldWriter::Floats(const std::vector<float>& numbers) {
  Number(static_cast<std::uint32_t>(numbers.size()));
  bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float));
}

void FieldReader::Floats(std::vector<float>& numbers) {
  std::uint32_t count = 0;
  Number(count);
  const std::string_view bytes = Next(count * sizeof(float));
  numbers.resize(count);
  if (count > 0) std::memcpy(numbers.data(), bytes.data(), bytes.size());
}

void FieldReader::Flag(bool& flag) {
  const char value = Next(1).front();
  if (value != '\0' && value != '\1') Fail("a flag of the record is neither set nor unset");
  flag = value == '\1';
}

void FieldReader::Finish() const {
  if (!bytes_.empty()) Fail("the record is {} bytes longer than its fields", bytes_.size());
}

std::string_view FieldReader::Next(std::size_t count) {
  if (count > bytes_.size()) Fail("the record ends before its fields");
  const std::string_view next = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return next;
}

}  // namespace ariadne::drivers
