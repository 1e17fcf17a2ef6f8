#include "slam/map/octree_bricks.h"

namespace ariadne::slam {
namespace {

constexpr int kBrickBits = 3;
constexpr std::int32_t kInBrick = (1 << kBrickBits) - 1;

std::uint64_t KeyOf(const LeafIndex& index) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = key << 18 | static_cast<std::uint32_t>(index[axis] + OctreeBricks::kHalfWidth) >> kBrickBits;
  }
  return key;
}

unsigned PlaceOf(const LeafIndex& index) {
  const auto spread = [&](int axis) { return internal::kSpread[index[axis] & kInBrick] << axis; };
  return static_cast<unsigned>(spread(0) | spread(1) | spread(2));
}

}  // namespace

OctreeLeaf& OctreeBricks::Brick::At(unsigned place) {
  const unsigned word = place >> 6;
  const std::uint64_t bit = std::uint64_t{1} << (place & 63);
  const std::size_t rank = before_[word] + std::popcount(occupied_[word] & (bit - 1));
  if ((occupied_[word] & bit) == 0) {
    // Grows by a quarter, not to the double as a vector would: memory is what counts here.
    if (leaves_.size() == leaves_.capacity()) leaves_.reserve(leaves_.size() + leaves_.size() / 4 + 2);
    leaves_.insert(leaves_.begin() + static_cast<std::ptrdiff_t>(rank), OctreeLeaf());
    occupied_[word] |= bit;
    for (unsigned later = word + 1; later < 8; ++later) ++before_[later];
  }
  return leaves_[rank];
}

OctreeLeaf& OctreeBricks::At(const LeafIndex& index) {
  const std::uint64_t key = KeyOf(index);
  if (key != last_key_) {
    const auto [entry, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(bricks_.size()));
    if (is_new) bricks_.emplace_back(index.unaryExpr([](std::int32_t i) { return i & ~kInBrick; }));
    last_key_ = key;
    last_ = entry->second;
  }
  return bricks_[last_].At(PlaceOf(index));
}

const OctreeBricks::Brick* OctreeBricks::Find(const LeafIndex& index) const {
  const auto found = numbers_.find(KeyOf(index));
  return found == numbers_.end() ? nullptr : &bricks_[found->second];
}

std::size_t OctreeBricks::bytes() const {
  // A bucket of the map holds the key, the number, and how far it is from where it wanted to be.
  constexpr std::size_t kBucket = 24;
  std::size_t bytes = numbers_.bucket_count() * kBucket + bricks_.size() * sizeof(Brick);
  for (const Brick& brick : bricks_) bytes += brick.heap_bytes();
  return bytes;
}

}  // namespace ariadne::slam
