#include "MovedVertices.h"

#include <regex>
#include <string>

#include <vtkActor.h>
#include <vtkShaderProperty.h>

namespace shadow
{

namespace
{

/// What VTK's vertex shaders make positions from.
#define POSITION_NAMES "(gl_Position|vertexMC|vertexVCVSOutput|MCDCMatrix|MCVCMatrix|VCDCMatrix)"

bool writesPosition(const std::string& code)
{
  static const std::regex assigned("\\b" POSITION_NAMES
                                   "\\s*(\\.\\s*\\w+|\\[[^\\]]*\\])?\\s*[-+*/]?=(?!=)");
  static const std::regex defined("#\\s*define\\s+" POSITION_NAMES "\\b");
  return std::regex_search(code, assigned) || std::regex_search(code, defined);
}

/// A piece of VTK's own code, not one of its tags, that is taken out.
bool takesPositionOut(const std::string& replaced)
{
  static const std::regex named("\\b" POSITION_NAMES "\\b");
  return replaced.find("//VTK::") == std::string::npos && std::regex_search(replaced, named);
}

#undef POSITION_NAMES

} // namespace

bool movesVertices(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  if (shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode())
  {
    return true;
  }
  for (int i = 0; i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    std::string replaced;
    std::string replacement;
    bool replaceFirst = false;
    bool replaceAll = false;
    shaders->GetNthShaderReplacement(i, replaced, replaceFirst, replacement, replaceAll);
    if (shaders->GetNthShaderReplacementTypeAsString(i) != "Fragment" &&
        (writesPosition(replacement) || takesPositionOut(replaced)))
    {
      return true;
    }
  }
  return false;
}

} // namespace shadow
