#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace ariadne::slam {

/// Makes room for `count` elements, and asks the system to back large vectors with huge pages: reading a
/// large binary file spends more time on taking small pages than on its points. Where the system does not
/// follow, nothing is lost but this.
template <typename T>
void ReserveInHugePages(std::vector<T>& vector, std::size_t count) {
  vector.reserve(count);
  constexpr std::size_t kHugePage = 1 << 21;  // [B]
  void* first = vector.data();
  std::size_t size = vector.capacity() * sizeof(T);
  if (std::align(kHugePage, kHugePage, first, size) == nullptr) return;  // too small for one
  madvise(first, size / kHugePage * kHugePage, MADV_HUGEPAGE);
}

}  // namespace ariadne::slam
