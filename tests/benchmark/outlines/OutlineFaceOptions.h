#pragma once

namespace shadow::benchmarks
{

/// Prints what pass 2 of TECHNIQUE_FACES costs with whole faces alone, with large ones split, and with flat
/// ones left out as well, on meshes of few large faces and of many small ones.
///
/// @param rounds  of turns; medians are printed
void compareFaceOptions(int rounds, int width, int height);

} // namespace shadow::benchmarks
