#ifndef shadow_examples_StlFile_h
#define shadow_examples_StlFile_h

#include <memory>
#include <string>

#include "TemporaryModel.h"

namespace shadow::examples
{

/// Looks at an STL file before its reader does.
///
/// @return a copy for vtkSTLReader to read instead, of a text file with a byte order mark or comments before
/// "solid", or with names longer than the reader's lines; else nothing
/// @throws UserError for a file that is neither text nor as long as its header says
/// @par Cost  reads a text file once
std::unique_ptr<TemporaryModel> checkStl(const std::string& file);

} // namespace shadow::examples

#endif
