#ifndef shadow_examples_StlFile_h
#define shadow_examples_StlFile_h

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "TemporaryModel.h"

namespace shadow::examples
{

/// What a look at an STL file found.
struct StlFindings
{
  std::unique_ptr<TemporaryModel> copy; ///< for vtkSTLReader to read instead; none: the file itself
  std::array<double, 3> shift = {0.0, 0.0, 0.0}; ///< was taken off the copy's points: the reader has single precision
};

/// Looks at an STL file before its reader does.
///
/// There is a copy of a text file with a byte order mark, with comments, with "solid" not in small letters at the
/// very start, with names longer than the reader's lines, or with points so far away that single precision would
/// be seen.
/// @param[out] warnings  of a binary file whose points have such steps themselves
/// @throws UserError for a text in which something is wrong, see StlGrammar, and for a file that is neither text nor
/// as long as its header says
/// @par Cost  reads a file once or twice
StlFindings checkStl(const std::string& file, std::vector<std::string>& warnings);

} // namespace shadow::examples

#endif
