#pragma once

#include "NodeVisitor.h"
#include "SEDGeode.h"

namespace shadow
{

/// Tells every SEDGeode what to draw in the coming pass: its geometry, or its volume for one light.
///
/// @par Source  Shi 2006, chapter 4.2.2
class SVStateVisitor : public NodeVisitor
{
public:
  explicit SVStateVisitor(const RenderMode& renderMode) : mode(renderMode) {}

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override { geode.renderMode = this->mode; }

private:
  RenderMode mode;
};

} // namespace shadow
