#pragma once

#include <iosfwd>
#include <vector>

#include "SavingsRun.h"

namespace shadow::benchmarks
{

/// Milliseconds, and ratios to plain VTK and to the shadow map; what the columns are.
void printSavings(std::ostream& out, const SavingsRow& row);
void printSavingsHead(std::ostream& out);

/// The work of each drawer's last frame.
void printWork(std::ostream& out, const std::vector<SavingsRow>& rows);

/// What each row has to reach, and whether it does.
void printAims(std::ostream& out, const std::vector<SavingsRow>& rows);

/// A line for each row and drawer.
void printSavingsTable(std::ostream& out, const std::vector<SavingsRow>& rows);

/// The exponent p of the power law y = c x^p that comes nearest, by least squares of logarithms.
/// @pre at least two points, all coordinates above 0
double fitExponent(const std::vector<std::pair<double, double>>& points);

} // namespace shadow::benchmarks
