#include "OptionValues.h"

#include "UserError.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace shadow::examples
{
namespace
{

// Below this length (VTK's own limit for a camera) a direction is not told from rounding.
constexpr double SHORTEST = 1e-20;

// Sine of the least angle between the view direction and the view-up vector.
constexpr double LEAST_SINE = 1e-6;

double length(const Vector3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

Vector3 difference(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 normalized(const Vector3& v)
{
  const double l = length(v);
  return {v[0] / l, v[1] / l, v[2] / l};
}

Vector3 cross(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool hasDirection(const Vector3& v)
{
  const double l = length(v);
  return std::isfinite(l) && l > SHORTEST;
}

// A leading plus is what people write and std::from_chars does not take.
std::string withoutPlus(const std::string& text)
{
  return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

[[noreturn]] void fail(const std::string& option, const std::string& text, const std::string& why)
{
  throw UsageError(option + ": " + (text.empty() ? "an empty value" : "'" + text + "'") + " " + why);
}

Vector3 threeOf(const std::vector<double>& numbers, std::size_t first)
{
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

} // namespace

std::vector<std::string> splitText(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin))
  {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

double parseNumber(const std::string& option, const std::string& text)
{
  const std::string digits = withoutPlus(text);
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  if (result.ec == std::errc::result_out_of_range)
  {
    fail(option, text, "is outside the range of numbers");
  }
  if (result.ec != std::errc() || result.ptr != end)
  {
    fail(option, text, "is not a number");
  }
  if (!std::isfinite(value))
  {
    fail(option, text, "is not finite");
  }
  return value;
}

int parseInteger(const std::string& option, const std::string& text, int lowest, int highest)
{
  const std::string digits = withoutPlus(text);
  int value = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  const bool number = result.ec == std::errc() || result.ec == std::errc::result_out_of_range;
  if (!number || result.ptr != end)
  {
    fail(option, text, "is not a whole number");
  }
  if (result.ec != std::errc() || value < lowest || value > highest)
  {
    const bool open = highest == std::numeric_limits<int>::max();
    fail(option, text,
         open ? "is not " + std::to_string(lowest) + " or more"
              : "is not between " + std::to_string(lowest) + " and " + std::to_string(highest));
  }
  return value;
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text, std::size_t count)
{
  const std::vector<std::string> parts = splitText(text, ',');
  if (parts.size() != count)
  {
    fail(option, text,
         "has " + std::to_string(parts.size()) + " value" + (parts.size() == 1 ? "" : "s") + ", not " +
             std::to_string(count));
  }
  std::vector<double> numbers;
  for (const std::string& part : parts)
  {
    numbers.push_back(parseNumber(option, part));
  }
  return numbers;
}

std::size_t parseChoice(const std::string& option, const std::string& text,
                        const std::vector<std::string>& allowed)
{
  std::string list;
  for (std::size_t i = 0; i < allowed.size(); ++i)
  {
    if (allowed[i] == text)
    {
      return i;
    }
    list += (i > 0 ? ", " : "") + allowed[i];
  }
  fail(option, text, "is unknown; allowed: " + list);
}

SizeOption parseSize(const std::string& text)
{
  const std::vector<std::string> parts = splitText(text, 'x');
  if (parts.size() != 2)
  {
    fail("--size", text, "is not WIDTHxHEIGHT, as in 1280x720");
  }
  constexpr int most = std::numeric_limits<int>::max();
  return {parseInteger("--size", parts[0], 1, most), parseInteger("--size", parts[1], 1, most)};
}

LightOption parseLight(const std::string& text)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
  {
    fail("--light", text, "is not point:X,Y,Z, directional:DX,DY,DZ or spot:X,Y,Z,TX,TY,TZ,CONE");
  }
  LightOption light;
  const std::string values = text.substr(colon + 1);
  switch (parseChoice("--light", text.substr(0, colon), {"point", "directional", "spot"}))
  {
  case 0:
    light.kind = LightOption::Kind::Point;
    light.position = threeOf(parseNumbers("--light", values, 3), 0);
    break;
  case 1:
    light.kind = LightOption::Kind::Directional;
    light.direction = threeOf(parseNumbers("--light", values, 3), 0);
    if (!hasDirection(light.direction))
    {
      fail("--light", text, "has no direction");
    }
    light.direction = normalized(light.direction);
    break;
  default:
  {
    const std::vector<double> numbers = parseNumbers("--light", values, 7);
    light.kind = LightOption::Kind::Spot;
    light.position = threeOf(numbers, 0);
    light.target = threeOf(numbers, 3);
    light.coneAngle = numbers[6];
    if (!hasDirection(difference(light.target, light.position)))
    {
      fail("--light", text, "has no direction: position and target are the same");
    }
    if (light.coneAngle <= 0.0 || light.coneAngle > 180.0)
    {
      fail("--light", text, "has a cone that is not above 0 and up to 180 degrees");
    }
  }
  }
  return light;
}

CameraOption parseCamera(const std::string& text)
{
  const std::vector<double> numbers = parseNumbers("--camera", text, 10);
  CameraOption camera;
  camera.position = threeOf(numbers, 0);
  camera.focalPoint = threeOf(numbers, 3);
  camera.viewUp = threeOf(numbers, 6);
  camera.viewAngle = numbers[9];
  const Vector3 view = difference(camera.focalPoint, camera.position);
  if (!hasDirection(view))
  {
    fail("--camera", text, "has no view direction: position and focal point are the same");
  }
  if (!hasDirection(camera.viewUp) || length(cross(normalized(view), normalized(camera.viewUp))) < LEAST_SINE)
  {
    fail("--camera", text, "has a view-up vector that is zero or along the view direction");
  }
  if (camera.viewAngle <= 0.0 || camera.viewAngle >= 180.0)
  {
    fail("--camera", text, "has a view angle that is not between 0 and 180 degrees");
  }
  return camera;
}

} // namespace shadow::examples
