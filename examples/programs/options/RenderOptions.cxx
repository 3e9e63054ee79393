#include "RenderOptions.h"

#include "CommandLine.h"

namespace shadow::examples
{
namespace
{

struct Method
{
  std::string name;
  std::string meaning;
};

const std::vector<Method>& silhouetteMethods()
{
  static const std::vector<Method> methods = {
      {"auto", "brute-force for small meshes, hierarchical for large ones"},
      {"brute-force", "facing of every triangle, then every edge, on the CPU"},
      {"edge-buffer", "triangles flip bits at their edges"},
      {"triangular", "TA: a set of directed edges in which opposite ones cancel"},
      {"visible-nonvisible", "VnV: edges with one neighbour that faces the light"},
      {"hybrid", "HSD: TA on polygons merged from coplanar triangles"},
      {"hierarchical", "only clusters of triangles that do not face the light as one, on the CPU"},
      {"topology-aware-mesh", "TAM: each triangle compares itself with its neighbours"},
      {"facing-texture", "facing drawn into a texture by the GPU and read back"},
      {"facing-texture-resident", "the same without reading it back"},
      {"vertex-texture", "the state of every edge drawn into a texture by the GPU"},
      {"vertex-extrusion", "every edge a quad, widened by the vertex shader"},
      {"geometry-shader", "triangles with adjacency, extruded by the geometry shader"},
      {"compute", "edges listed by compute shaders and drawn indirectly; needs GL 4.3"}};
  return methods;
}

} // namespace

std::string describeSilhouettes()
{
  std::string text = "how silhouettes are found; the mask is the same:";
  for (const Method& method : silhouetteMethods())
  {
    text += "\n" + method.name + ": " + method.meaning;
  }
  return text;
}

const std::vector<std::string>& stencilNames()
{
  static const std::vector<std::string> names = {"auto", "zpass", "zfail"};
  return names;
}

const std::vector<std::string>& silhouetteNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> list;
    for (const Method& method : silhouetteMethods())
    {
      list.push_back(method.name);
    }
    return list;
  }();
  return names;
}

const std::vector<std::string>& compositingNames()
{
  static const std::vector<std::string> names = {"mask", "additive"};
  return names;
}

RenderOptions parseRenderOptions(int argc, const char* const* argv)
{
  RenderOptions options;
  CommandLine commandLine({"shadow_render",
                           "Draws meshes with exact hard shadows into a PNG file, without a display.",
                           "shadow.png",
                           "shadow mask, 8-bit grey PNG: 255 reached, 0 in shadow; "
                           "one numbered file for each of several lights"},
                          options);
  commandLine.addShadowOptions();
  commandLine.parse(argc, argv);
  return options;
}

} // namespace shadow::examples
