#pragma once

namespace shadow::benchmarks
{

/// Prints, for each of the shared meshes, what the layouts of its topology-aware mesh measure against the
/// mesh itself beside the paper's ratios, and how many of its faces are left out.
void printLayouts();

} // namespace shadow::benchmarks
