#pragma once

#include <string>

namespace shadow::test
{

/// While it lives, shaders that are new do something else: where their source has a text, another is put.
/// @pre VTK has loaded the GL's functions
class FaultyShaders
{
public:
  FaultyShaders(const std::string& text, const std::string& other);
  ~FaultyShaders();
  FaultyShaders(const FaultyShaders&) = delete;
  FaultyShaders& operator=(const FaultyShaders&) = delete;

  int countAltered() const; ///< shaders
};

/// While it lives, the GL does nothing when it is asked to draw what the GPU has counted.
/// @pre VTK has loaded the GL's functions
class LostIndirectDraws
{
public:
  LostIndirectDraws();
  ~LostIndirectDraws();
  LostIndirectDraws(const LostIndirectDraws&) = delete;
  LostIndirectDraws& operator=(const LostIndirectDraws&) = delete;
};

/// While it lives, the GL keeps stencils as they are.
/// @pre VTK has loaded the GL's functions
class LostStencilCounts
{
public:
  LostStencilCounts();
  ~LostStencilCounts();
  LostStencilCounts(const LostStencilCounts&) = delete;
  LostStencilCounts& operator=(const LostStencilCounts&) = delete;
};

} // namespace shadow::test
