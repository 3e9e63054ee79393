#ifndef shadow_examples_ObjCopy_h
#define shadow_examples_ObjCopy_h

#include <array>
#include <string>

#include "TemporaryModel.h"

namespace shadow::examples
{

/// What a look through an OBJ file found.
struct ObjFindings
{
  std::string damage;                        ///< one line with the number of the line; empty: none
  bool unusual = false;                      ///< right, but VTK's reader needs a copy that is written plainly
  std::array<double, 3> shift = {0.0, 0.0, 0.0}; ///< to be taken off the points: else single precision, which
                                                 ///< VTK's reader has, would round them to a visible grid
};

/// A temporary copy of an OBJ file as VTK's reader understands it: whole lines without comments, corners without
/// empty ends, points relative to a shift.
class ObjCopy : public TemporaryModel
{
public:
  /// @throws UserError when no file can be written
  ObjCopy(const std::string& file, const std::array<double, 3>& shift);
};

} // namespace shadow::examples

#endif
