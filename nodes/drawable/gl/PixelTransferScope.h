#pragma once

namespace shadow
{

/// While it stands, pixels go to and from plain memory, rows without gaps, whatever was set before; puts that
/// back at the end.
class PixelTransferScope
{
public:
  PixelTransferScope();
  ~PixelTransferScope();
  PixelTransferScope(const PixelTransferScope&) = delete;
  PixelTransferScope& operator=(const PixelTransferScope&) = delete;

private:
  static constexpr int settings = 10;
  int stores[settings];
  int packBuffer = 0;
  int unpackBuffer = 0;
};

} // namespace shadow
