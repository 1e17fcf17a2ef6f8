#pragma once

namespace ariadne::bench {

/// Registers the benchmarks of the factors of many point pairs.
void RegisterFactors();

}  // namespace ariadne::bench
