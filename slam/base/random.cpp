#include "slam/base/random.h"

#include <cmath>
#include <numbers>

namespace ariadne {

RandomStream NamedStream(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a: any fixed mixing of the name will do
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  std::seed_seq mixed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32)};
  return RandomStream(mixed);
}

double DrawUniform(RandomStream& stream, double low, double high) {
  const double unit = static_cast<double>(stream() >> 11) * 0x1.0p-53;  // [0, 1)
  return low + (high - low) * unit;
}

double DrawNormal(RandomStream& stream, double mean, double sigma) {
  // Box-Muller; one of the pair is dropped so that each call takes exactly two numbers of the stream.
  const double u = 1.0 - DrawUniform(stream, 0.0, 1.0);
  const double v = DrawUniform(stream, 0.0, 1.0);
  return mean + sigma * std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

}  // namespace ariadne
