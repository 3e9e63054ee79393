#ifndef shadow_examples_OptionValues_h
#define shadow_examples_OptionValues_h

#include <array>
#include <string>
#include <vector>

namespace shadow::examples
{

/// x, y, z in world space.
using Vector3 = std::array<double, 3>;

/// One --light. Which members count depends on the kind.
struct LightOption
{
  enum class Kind
  {
    Point,
    Directional,
    Spot
  };

  Kind kind = Kind::Point;
  Vector3 position = {0.0, 0.0, 0.0};   ///< Point and Spot
  Vector3 target = {0.0, 0.0, 0.0};     ///< Spot: a point on the axis of the cone
  Vector3 direction = {0.0, -1.0, 0.0}; ///< Directional: the way the light travels, of any length
  double coneAngle = 180.0; ///< Spot: degrees between axis and rim; from 90 on it shines everywhere
};

/// --camera.
struct CameraOption
{
  Vector3 position = {0.0, 0.0, 1.0};
  Vector3 focalPoint = {0.0, 0.0, 0.0};
  Vector3 viewUp = {0.0, 1.0, 0.0};
  double viewAngle = 30.0; ///< vertical, in degrees
};

/// --size, in pixels.
struct SizeOption
{
  int width = 1280;
  int height = 720;
};

/// The text between separators; "a,,b" has three parts.
std::vector<std::string> splitText(const std::string& text, char separator);

/// A finite number that takes up the whole text, the same in every locale.
///
/// @param option  its name, for the message
/// @throws UsageError
double parseNumber(const std::string& option, const std::string& text);

/// An integer that takes up the whole text and lies in [lowest, highest].
///
/// @throws UsageError
int parseInteger(const std::string& option, const std::string& text, int lowest, int highest);

/// Exactly `count` numbers separated by commas.
///
/// @throws UsageError
std::vector<double> parseNumbers(const std::string& option, const std::string& text, std::size_t count);

/// Where `text` stands in `allowed`.
///
/// @throws UsageError that names the allowed values
std::size_t parseChoice(const std::string& option, const std::string& text,
                        const std::vector<std::string>& allowed);

/// "WIDTHxHEIGHT", both at least 1. What the GL can do is checked later.
///
/// @throws UsageError
SizeOption parseSize(const std::string& text);

/// "point:X,Y,Z", "directional:DX,DY,DZ" or "spot:X,Y,Z,TX,TY,TZ,CONE".
///
/// @throws UsageError, also for a direction without length and a cone outside (0, 180]
LightOption parseLight(const std::string& text);

/// "PX,PY,PZ,FX,FY,FZ,UX,UY,UZ,ANGLE".
///
/// @throws UsageError, also for a view that has no direction or whose up is along it, and for an angle
/// outside (0, 180)
CameraOption parseCamera(const std::string& text);

} // namespace shadow::examples

#endif
