#pragma once

namespace shadow::benchmarks
{

/// Rows of the first frame of large scenes, plain VTK's beside that with shadows: one mesh, and as many triangles in
/// many meshes.
void registerFirstFrames();

} // namespace shadow::benchmarks
