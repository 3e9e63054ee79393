#pragma once

#include <cstdint>

namespace shadow
{

/// A number that has not been handed out before, and larger than all that have; never 0. May be asked by
/// several threads.
std::uint64_t nextRevision();

} // namespace shadow
