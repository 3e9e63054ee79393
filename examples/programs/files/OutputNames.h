#ifndef shadow_examples_OutputNames_h
#define shadow_examples_OutputNames_h

#include "RenderOptions.h"

#include <string>

namespace shadow::examples
{

/// The files that a program writes: "shadow.png", with --frames "shadow-0000.png", ...; "mask.png", with
/// several masks a picture "mask-0.png", ..., with both "mask-0000-0.png", ...
class OutputNames
{
public:
  /// @param masks  for each picture, where any are asked for
  OutputNames(const RenderOptions& options, std::size_t masks);

  std::string picture(int frame) const;
  std::string mask(int frame, std::size_t index) const; ///< empty when no mask is asked for
  const std::string& report() const;                    ///< empty when no report is asked for

  /// Makes sure that all of them can be written, and that none takes the place of another or of a model.
  ///
  /// @throws UserError
  void check() const;

private:
  const RenderOptions& options;
  std::size_t maskCount; ///< a frame
};

} // namespace shadow::examples

#endif
