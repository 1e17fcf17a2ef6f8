#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace ariadne {

/// The generator that belongs to one source of randomness. Each source has a name of its own
/// ("scanner/range", "odometry/heading"), so that drawing more from one leaves the others untouched.
using RandomStream = std::mt19937_64;

RandomStream NamedStream(std::uint64_t seed, std::string_view name);

/// Draws that are the same on every standard library, unlike those of std::*_distribution.
double DrawUniform(RandomStream& stream, double low, double high);
double DrawNormal(RandomStream& stream, double mean, double sigma);

}  // namespace ariadne
