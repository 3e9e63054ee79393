#ifndef shadow_examples_OutputFiles_h
#define shadow_examples_OutputFiles_h

#include <string>

class vtkImageData;

namespace shadow::examples
{

/// Makes sure, before the long work begins, that a file can be written: its folder is there and may be
/// written to, and the name is not a folder's or a socket's. Symbolic links are followed.
///
/// @param option     for the message
/// @param extension  that the name must have, as ".png"; "" for any
/// @throws UserError
void checkTarget(const std::string& option, const std::string& file, const std::string& extension);

/// Whether two names mean one file; it need not exist.
bool isSameFile(const std::string& a, const std::string& b);

/// "out/shadow.png" and "0003" give "out/shadow-0003.png".
std::string numberedName(const std::string& file, const std::string& number);

/// Writes a file whole or not at all: to another name in the same folder first, which then takes the place of
/// what was there. A symbolic link stays, and what it leads to is written; what is no file, a device or a pipe,
/// stays, too, and is written to as it is.
///
/// @throws UserError
void writeFile(const std::string& file, const std::string& content);

/// Writes an 8-bit image as PNG, as writeFile does. VTK's bottom row is the last row of the PNG.
///
/// @throws UserError
void writePng(const std::string& file, vtkImageData* image);

} // namespace shadow::examples

#endif
