#pragma once

namespace shadow::benchmarks
{

/// Prints what the published forms do, counted, beside what the paper's formulas say, for n = 10, m = 5 and
/// n = 100, m = 10, and why they differ.
///
/// @return  false, with a line on the standard error stream, when a published form finds another silhouette
///          than brute force
bool printOperationTables();

} // namespace shadow::benchmarks
