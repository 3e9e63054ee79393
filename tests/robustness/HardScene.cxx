#include "HardScene.h"

#include <vtkCamera.h>

#include "SoupPolyData.h"

namespace shadow::robustness
{

vtkActor* HardScene::addMesh(const TriangleSoup& soup)
{
  return this->addPolyData(test::toPolyData(soup));
}

vtkActor* HardScene::addCube(const glm::dvec3& footMC, double size)
{
  return this->addMesh(test::makeCube(footMC + glm::dvec3(0.0, 0.5 * size, 0.0), size));
}

vtkActor* HardScene::addPlate(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
  return this->addMesh(makeQuad(corner, u, v));
}

vtkActor* HardScene::addGround(double half)
{
  return this->addPlate({-half, 0.0, -half}, {0.0, 0.0, 2.0 * half}, {2.0 * half, 0.0, 0.0});
}

void HardScene::addSolids()
{
  this->addCube({-0.9, 0.0, 0.2});
  this->addMesh(moved(upright(test::makeTorus(0.7, 0.25, 48, 24)), {0.9, 0.9, 0.1}));
  this->addGround();
}

void HardScene::finish()
{
  this->addGround();
  this->addTwoLights();
  this->lookAtGround();
}

void HardScene::show(const TriangleSoup& soup)
{
  this->addMesh(soup);
  this->finish();
}

void HardScene::addTwoLights()
{
  this->addPointLight(-2.1, 4.3, 2.7);
  this->addDirectionalLight(-0.53, -1.0, -0.31);
}

void HardScene::look(const glm::dvec3& eye, const glm::dvec3& focus, double angle)
{
  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(angle);
  this->renderer->ResetCameraClippingRange();
}

TriangleSoup makeRing()
{
  return moved(upright(test::makeTorus(0.9, 0.35, 48, 24)), {0.0, 0.9, 0.0});
}

TriangleSoup upright(TriangleSoup soup)
{
  for (glm::dvec3& point : soup.points)
  {
    point = {point.x, point.z, -point.y};
  }
  return soup;
}

TriangleSoup moved(TriangleSoup soup, const glm::dvec3& by)
{
  for (glm::dvec3& point : soup.points)
  {
    point += by;
  }
  return soup;
}

TriangleSoup scaled(TriangleSoup soup, double by)
{
  for (glm::dvec3& point : soup.points)
  {
    point *= by;
  }
  return soup;
}

TriangleSoup makeQuad(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
  TriangleSoup soup;
  soup.points = {corner, corner + u, corner + u + v, corner + v};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  return soup;
}

TriangleSoup makeGrid(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, int cells)
{
  TriangleSoup soup;
  const auto at = [&](int i, int j)
  { return corner + (static_cast<double>(i) / cells) * u + (static_cast<double>(j) / cells) * v; };
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      soup.points.insert(soup.points.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      soup.triangles.push_back({first, first + 1, first + 2});
      soup.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return soup;
}

TriangleSoup makeGridCube(const glm::dvec3& centre, double size, int cells)
{
  const double h = 0.5 * size;
  const glm::dvec3 x(size, 0.0, 0.0), y(0.0, size, 0.0), z(0.0, 0.0, size);
  const glm::dvec3 low = centre - glm::dvec3(h);
  const glm::dvec3 high = centre + glm::dvec3(h);
  TriangleSoup soup = makeGrid(low, y, x, cells);
  test::append(soup, makeGrid(low, x, z, cells));
  test::append(soup, makeGrid(low, z, y, cells));
  test::append(soup, makeGrid(high, -x, -y, cells));
  test::append(soup, makeGrid(high, -z, -x, cells));
  test::append(soup, makeGrid(high, -y, -z, cells));
  return soup;
}

TriangleSoup makeDome(double radius, std::uint32_t slices)
{
  TriangleSoup sphere = upright(test::makeSphere(radius, slices, slices));
  TriangleSoup dome;
  dome.points = sphere.points;
  for (const auto& corners : sphere.triangles)
  {
    const double middle =
        sphere.points[corners[0]].y + sphere.points[corners[1]].y + sphere.points[corners[2]].y;
    if (middle > 0.0)
    {
      dome.triangles.push_back(corners);
    }
  }
  return dome;
}

} // namespace shadow::robustness
