#pragma once

#include <glm/glm.hpp>

namespace shadow::test
{

/// Sign of dot(cross(b - a, c - a), light.xyz - light.w * a) in whole numbers of 1024 bits, which shares
/// nothing with the library's exact arithmetic.
///
/// @param light  w = 0 or 1
/// @throws std::range_error  when the coordinates spread over more than 300 binary digits
int exactSign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec4& light);

} // namespace shadow::test
