#include "SilhouetteProbe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>

#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include "BruteForceSilhouette.h"
#include "Capabilities.h"
#include "OpenGL.h"
#include "TexelReadBack.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

void sortEdges(std::vector<SilhouetteEdge>& silhouette)
{
  std::sort(silhouette.begin(), silhouette.end(),
            [](const SilhouetteEdge& a, const SilhouetteEdge& b)
            { return std::tuple(a.from, a.to, a.multiplicity) < std::tuple(b.from, b.to, b.multiplicity); });
}

} // namespace

SilhouetteProbe::SilhouetteProbe(const SEDGeometry& geometry)
    : geode(std::make_shared<SEDGeometry>(geometry)), path{&this->geode}
{
  this->window->SetSize(16, 16);
  const vtkNew<vtkRenderer> renderer;
  this->window->AddRenderer(renderer);
  this->window->Render();
  this->window->MakeCurrent();
}

void SilhouetteProbe::find(GPUSilhouette& method, const std::vector<glm::dvec4>& lightsMC)
{
  this->lights.clear();
  this->state.lights.clear();
  for (const glm::dvec4& lightMC : lightsMC)
  {
    const auto index = static_cast<int>(this->lights.size());
    this->lights.push_back({index, lightMC});
    this->state.lights[index].lightMC = lightMC;
    this->state.lights[index].faced = true;
  }
  GPUSilhouette::Frame frame;
  frame.window = this->window;
  frame.lights = &this->lights;
  frame.view = &this->view;
  const GPUSilhouette::Surface surface = {&this->geode, &this->state, &this->path, glm::dmat4(1.0),
                                          FaceCulling::None};
  std::string error;
  if (!method.begin(frame, error) || !method.prepare(surface, error) || !method.finishPreparing(error))
  {
    throw std::runtime_error(error);
  }
}

std::vector<std::uint32_t> SilhouetteProbe::readWords(const TexelArray& texels) const
{
  TexelReadBack readBack;
  std::vector<std::uint32_t> words;
  readBack.start(this->window->GetState(), texels);
  if (!readBack.fetch(words))
  {
    throw std::runtime_error("nothing read back");
  }
  readBack.release();
  return words;
}

SilhouetteProbe::Silhouettes SilhouetteProbe::read(const VertexTexture& method) const
{
  const std::vector<std::uint32_t> words = this->readWords(method.getEdgeTexels(this->path));
  Silhouettes silhouettes(this->lights.size());
  const std::vector<Edge> edges = this->getGeometry().getEdges().toVector();
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    const std::uint32_t* texel = &words.at(4 * edge);
    for (std::size_t light = 0; light < silhouettes.size(); ++light)
    {
      const auto bit = [&](std::size_t channel) { return (texel[channel] >> light) & 1u; };
      const auto [from, to] = edges[edge].vertices;
      if (bit(0) != 0)
      {
        silhouettes[light].push_back({from, to, 1 + bit(2)});
      }
      if (bit(1) != 0)
      {
        silhouettes[light].push_back({to, from, 1 + bit(2)});
      }
    }
  }
  return silhouettes;
}

SilhouetteProbe::Silhouettes SilhouetteProbe::read(const ComputeSilhouette& method) const
{
  const ComputeSilhouette::Lists lists = method.getLists(this->path);
  const std::vector<std::uint32_t> words = this->readWords(*lists.entries);
  std::vector<std::array<EdgeQuads::Command, 2>> commands(this->lights.size());
  glBindBuffer(GL_COPY_READ_BUFFER, lists.commands);
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(commands.size() * sizeof(commands[0])),
                     commands.data());
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  Silhouettes silhouettes(this->lights.size());
  const std::vector<Edge> edges = this->getGeometry().getEdges().toVector();
  for (std::size_t light = 0; light < silhouettes.size(); ++light)
  {
    const std::uint32_t count = commands[light][0].indices / EdgeQuads::indicesOfQuad;
    if (commands[light][1].indices != count * EdgeQuads::indicesOfFan || count > edges.size())
    {
      throw std::runtime_error("quads and fans differ in number, or are more than edges");
    }
    for (std::uint32_t place = 0; place < count; ++place)
    {
      const std::uint32_t entry = words.at(light * edges.size() + place);
      const auto [from, to] = edges.at(entry >> 2).vertices;
      const std::uint32_t times = 1 + ((entry >> 1) & 1u);
      silhouettes[light].push_back((entry & 1u) != 0 ? SilhouetteEdge{to, from, times}
                                                     : SilhouetteEdge{from, to, times});
    }
  }
  return silhouettes;
}

bool SilhouetteProbe::canCompute() const
{
  return queryCapabilities().compute;
}

std::size_t countOpenVertices(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette)
{
  const std::vector<std::uint32_t> first = findFirstAtPosition(geometry);
  std::map<std::uint32_t, std::int64_t> balance;
  for (const SilhouetteEdge& edge : silhouette)
  {
    balance[first[edge.from]] += edge.multiplicity;
    balance[first[edge.to]] -= edge.multiplicity;
  }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& vertex) { return vertex.second != 0; }));
}

bool isSameSilhouette(std::vector<SilhouetteEdge> a, std::vector<SilhouetteEdge> b)
{
  sortEdges(a);
  sortEdges(b);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SilhouetteEdge& first, const SilhouetteEdge& second) {
                      return first.from == second.from && first.to == second.to &&
                             first.multiplicity == second.multiplicity;
                    });
}

std::vector<SilhouetteEdge> findOnCPU(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  return BruteForceSilhouette().find(geometry, computeFacing(geometry, lightMC),
                                     chooseCasting(geometry, lightMC));
}

glm::dvec4 makeInPlaneLight(const SEDGeometry& torus, std::uint32_t n, std::uint32_t place)
{
  if (place % 2 == 0)
  {
    const auto corner = [n](std::uint32_t j)
    {
      const double angle = 2.0 * 3.14159265358979323846 * j / n;
      return glm::dvec2(2.0 + 0.5 * std::cos(angle), 0.5 * std::sin(angle));
    };
    const glm::dvec2 a = corner(place / 2 % n);
    const glm::dvec2 b = corner(place / 2 % n + 1);
    const double height = a.y - a.x * (b.y - a.y) / (b.x - a.x);
    return std::abs(height) < 1e3 ? glm::dvec4(0.0, 0.0, height, 1.0) : glm::dvec4(0.0, 0.0, 1.0, 0.0);
  }
  std::mt19937 random(place);
  const std::size_t triangle = random() % torus.getTriangles().size();
  const auto at = [&](std::size_t corner)
  { return glm::dvec3(torus.getPositions()[torus.getTriangles()[triangle][corner]]); };
  std::uniform_real_distribution<double> reach(-60.0, 60.0);
  const double s = reach(random);
  const double t = reach(random);
  return {at(0) + s * (at(1) - at(0)) + t * (at(2) - at(0)), 1.0};
}

} // namespace shadow::test
