#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <vector>

#include "slam/map/octree_leaf.h"

namespace ariadne::slam {

/// A leaf's place in the lattice of all leaves: it covers edge * [i, i + 1) on each axis.
using LeafIndex = Eigen::Matrix<std::int32_t, 3, 1>;

/// Where the leaves of an octree are kept: the lowest three levels of the tree are bricks of 8 x 8 x 8
/// places, each with a bit per place and, without gaps, the leaves that are there. A leaf is found by its
/// brick (a hash map) and the number of bits before its own, and costs little more than its 48 bytes.
class OctreeBricks {
 public:
  /// Leaves lie from -kHalfWidth to kHalfWidth - 1 on each axis.
  static constexpr std::int32_t kHalfWidth = 1 << 20;

  class Brick {
   public:
    explicit Brick(const LeafIndex& first) : first_(first) {}

    /// The leaf in a place; made if there is none yet.
    OctreeLeaf& At(unsigned place);
    std::size_t size() const { return leaves_.size(); }
    std::size_t heap_bytes() const { return leaves_.capacity() * sizeof(OctreeLeaf); }
    /// The place with the lowest coordinates.
    const LeafIndex& first() const { return first_; }
    /// Calls visit(index, leaf) in the order of places.
    template <typename Visit>
    void ForEach(const Visit& visit) const;

   private:
    std::array<std::uint64_t, 8> occupied_{};
    std::array<std::uint16_t, 8> before_{};  // leaves before those of a word
    std::vector<OctreeLeaf> leaves_;         // in the order of their places
    LeafIndex first_;
  };

  /// The leaf with this index; made if there is none yet.
  OctreeLeaf& At(const LeafIndex& index);
  /// The brick that holds an index; null where there is none.
  const Brick* Find(const LeafIndex& index) const;

  const std::deque<Brick>& bricks() const { return bricks_; }
  std::size_t bytes() const;

 private:
  struct Hash {
    std::size_t operator()(std::uint64_t key) const {
      key *= 0x9E3779B97F4A7C15ULL;
      return key ^ key >> 32;
    }
  };

  tsl::robin_map<std::uint64_t, std::uint32_t, Hash> numbers_;  // of bricks, by their key
  std::deque<Brick> bricks_;
  std::uint64_t last_key_ = ~std::uint64_t{0};  // neighbours in a scan are mostly in one brick
  std::uint32_t last_ = 0;
};

namespace internal {

/// The bits of a number 0 to 7, two apart.
inline constexpr std::array<std::uint8_t, 8> kSpread{0, 1, 8, 9, 64, 65, 72, 73};

}  // namespace internal

template <typename Visit>
void OctreeBricks::Brick::ForEach(const Visit& visit) const {
  std::size_t leaf = 0;
  for (unsigned word = 0; word < 8; ++word) {
    for (std::uint64_t bits = occupied_[word]; bits != 0; bits &= bits - 1) {
      const unsigned place = word << 6 | static_cast<unsigned>(std::countr_zero(bits));
      const auto axis = [&](unsigned a) {
        return static_cast<std::int32_t>((place >> a & 1) | (place >> (a + 3) & 1) << 1 |
                                         (place >> (a + 6) & 1) << 2);
      };
      visit(LeafIndex(first_ + LeafIndex(axis(0), axis(1), axis(2))), leaves_[leaf++]);
    }
  }
}

}  // namespace ariadne::slam
