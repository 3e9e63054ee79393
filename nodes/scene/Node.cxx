#include "Node.h"

#include "NodeVisitor.h"

namespace shadow
{

void Group::accept(NodeVisitor& visitor)
{
  visitor.enter(*this, [&] { visitor.apply(*this); });
}

void Transform::accept(NodeVisitor& visitor)
{
  visitor.enter(*this, [&] { visitor.apply(*this); });
}

} // namespace shadow
