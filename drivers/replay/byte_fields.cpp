#include "drivers/replay/byte_fields.h"

#include "drivers/replay/packed_floats.h"

namespace ariadne::drivers {

void FieldWriter::Floats(const std::vector<float>& numbers) {
  const PackedFloats packed = PackFloats(numbers);
  Number(static_cast<std::uint32_t>(numbers.size()));
  Number(static_cast<std::uint8_t>(packed.coding));
  bytes_ += packed.bytes;
}

void FieldReader::Floats(std::vector<float>& numbers) {
  std::uint32_t count = 0;
  std::uint8_t coding = 0;
  Number(count);
  Number(coding);
  if (count > bytes_.size()) Fail("the record ends before its {} numbers", count);
  numbers.resize(count);
  const auto taken = UnpackFloats(static_cast<FloatCoding>(coding), bytes_, numbers);
  if (!taken) Fail("{} numbers of the record are damaged", count);
  Next(*taken);
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
