// What the GPU holds of a mesh: of one that has moved it gets positions only.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "DeformedMesh.h"
#include "GeometryTexels.h"
#include "KeptByMesh.h"
#include "OpenGL.h"
#include "SEDGeometryDrawable.h"
#include "SilhouetteProbe.h"

using namespace shadow;
using namespace shadow::test;

TEST(GeometryTexels, MeshThatMoved_OnlyPositionsAreCopied)
{
  const TriangleSoup soup = makeTestTorus();
  const SEDGeometry before = build(soup);
  SilhouetteProbe probe(before); // a GL context
  GeometryTexels texels;
  std::string error;
  ASSERT_TRUE(texels.upload(before, error)) << error;

  SEDGeometryOptions options;
  options.previous = &before;
  const SEDGeometry stretched = build(moved(soup, stretch), options);
  ASSERT_TRUE(isSameMeshMoved(before, stretched));
  EXPECT_EQ(texels.update(stretched), stretched.getPositions().size());

  options.previous = &stretched;
  const SEDGeometry turned = build(moved(soup, turn), options);
  ASSERT_TRUE(isSameMeshMoved(stretched, turned));
  EXPECT_EQ(texels.update(turned), turned.getPositions().size() + turned.getTriangles().size());
  EXPECT_EQ(texels.update(turned), turned.getPositions().size());
  texels.release();
}

TEST(SEDGeometryDrawable, MeshThatMoved_OnlyPositionsAreCopied)
{
  const TriangleSoup soup = makeTestTorus();
  const SEDGeometry before = build(soup);
  SilhouetteProbe probe(before);
  SEDGeometryDrawable drawable(before);
  const std::size_t vertices = drawable.getVertexCount();
  const std::size_t triangleBytes = 12 * before.getTriangles().size();
  const std::size_t memory = drawable.getMemorySize();
  EXPECT_EQ(memory, 12 * vertices + triangleBytes);

  SEDGeometryOptions options;
  options.previous = &before;
  const SEDGeometry stretched = build(moved(soup, stretch), options);
  EXPECT_EQ(drawable.update(stretched), 12 * vertices);
  drawable.getVolumeVertexBuffer();
  const std::size_t volumeBytes = 32 * before.getPositions().size();
  EXPECT_EQ(drawable.getMemorySize(), memory + volumeBytes);
  EXPECT_EQ(drawable.update(before), 12 * vertices + volumeBytes);

  const SEDGeometry turned = build(moved(soup, turn), options);
  EXPECT_EQ(drawable.update(turned), 12 * drawable.getVertexCount() + volumeBytes + triangleBytes);
  EXPECT_EQ(drawable.update(turned), 12 * drawable.getVertexCount() + volumeBytes);
  drawable.release(false);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

namespace
{

/// What stands for data on the GPU.
struct Copy
{
  explicit Copy(int theNumber) : number(theNumber) {}
  void release(bool) {}
  std::size_t getMemorySize() const { return 1; }

  int number;
};

} // namespace

TEST(KeptByMesh, OneMeshStandsAndOneMoves_EachKeepsItsOwn)
{
  const TriangleSoup soup = makeTestTorus();
  const auto standing = std::make_shared<const SEDGeometry>(build(soup));
  KeptByMesh<Copy> kept;
  int made = 0;
  int updates = 0;
  const auto get = [&](const std::shared_ptr<const SEDGeometry>& geometry)
  {
    return kept
        .get(
            geometry, [&] { return std::make_unique<Copy>(++made); }, [&](Copy&) { ++updates; })
        ->number;
  };
  std::shared_ptr<const SEDGeometry> moving;
  for (int frame = 0; frame < 6; ++frame)
  {
    SEDGeometryOptions options;
    options.previous = moving != nullptr ? moving.get() : standing.get();
    moving = std::make_shared<const SEDGeometry>(
        build(moved(soup, [frame](const glm::dvec3& p) { return (1.0 + 0.1 * frame) * p; }), options));
    ASSERT_TRUE(isSameMeshMoved(*standing, *moving));
    // The one that moves is drawn first: what is kept for the other one is not asked for yet.
    const int number = get(moving);
    EXPECT_NE(get(standing), number);
    kept.sweep();
  }
  EXPECT_EQ(made, 2);
  EXPECT_EQ(updates, 5);
}
