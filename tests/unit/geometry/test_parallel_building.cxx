// What is built does not depend on how many threads there are, nor on what is built beside it.

#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "SEDGeometryBatch.h"
#include "TestMeshes.h"
#include "TestThreads.h"

namespace shadow::test
{

namespace
{

void expectSameTables(const EdgeTable& one, const EdgeTable& other)
{
  ASSERT_EQ(one.words.size(), other.words.size());
  for (std::size_t word = 0; word < one.words.size(); ++word)
  {
    ASSERT_EQ(one.words[word].place, other.words[word].place);
    ASSERT_EQ(one.words[word].inner, other.words[word].inner);
    ASSERT_EQ(one.words[word].outer, other.words[word].outer);
  }
  EXPECT_EQ(one.data, other.data);
  EXPECT_EQ(one.borders, other.borders);
}

/// By what they say of lights, which is all that they hold.
void expectSameTrees(const SEDGeometry& one, const SEDGeometry& other)
{
  std::mt19937 random(1);
  for (int light = 0; light < 8; ++light)
  {
    const glm::dvec4 place(randomPoint(random, 3.0), light % 2);
    const auto classify = [&place](const SEDGeometry& geometry)
    {
      FacingBits towards(geometry.getTriangles().size());
      FacingBits away(geometry.getTriangles().size());
      std::vector<ClusterTree::Quarters> mixed;
      const ScaledLight scaled = scaleLight(place, geometry.getReach());
      geometry.getClusterTree().classify(scaled, towards, away, mixed);
      std::vector<std::uint64_t> said = towards.getWords();
      said.insert(said.end(), away.getWords().begin(), away.getWords().end());
      for (const ClusterTree::Quarters& quarters : mixed)
      {
        said.push_back(std::uint64_t{quarters.word} << 32 | quarters.bits);
      }
      return said;
    };
    EXPECT_EQ(classify(one), classify(other));
  }
}

void expectSameReports(const SEDGeometryReport& one, const SEDGeometryReport& other)
{
  EXPECT_EQ(one.inputTriangles, other.inputTriangles);
  EXPECT_EQ(one.degenerateTriangles, other.degenerateTriangles);
  EXPECT_EQ(one.zeroAreaTriangles, other.zeroAreaTriangles);
  EXPECT_EQ(one.borderEdges, other.borderEdges);
  EXPECT_EQ(one.nonManifoldEdges, other.nonManifoldEdges);
  EXPECT_EQ(one.flippedTriangles, other.flippedTriangles);
  EXPECT_EQ(one.splitVertices, other.splitVertices);
}

void expectSame(const SEDGeometry& one, const SEDGeometry& other)
{
  EXPECT_EQ(one.getOrigin(), other.getOrigin());
  EXPECT_EQ(one.getPositions(), other.getPositions());
  EXPECT_EQ(one.getTriangles(), other.getTriangles());
  EXPECT_EQ(one.getInputOrder(), other.getInputOrder());
  EXPECT_EQ(one.getReversed().getWords(), other.getReversed().getWords());
  EXPECT_EQ(one.getInputReversed().getWords(), other.getInputReversed().getWords());
  EXPECT_EQ(one.getCopies().getWords(), other.getCopies().getWords());
  ASSERT_EQ(one.getPlaneBlocks().size(), other.getPlaneBlocks().size());
  EXPECT_EQ(std::memcmp(one.getPlaneBlocks().data(), other.getPlaneBlocks().data(),
                        one.getPlaneBlocks().size() * sizeof(PlaneBlock)),
            0);
  EXPECT_EQ(one.getReach(), other.getReach());
  EXPECT_EQ(one.getSharpness(), other.getSharpness());
  EXPECT_EQ(one.getLowerBound(), other.getLowerBound());
  EXPECT_EQ(one.getUpperBound(), other.getUpperBound());
  EXPECT_EQ(one.getCommonPlane(), other.getCommonPlane());
  expectSameReports(one.getReport(), other.getReport());
  expectSameTables(one.getEdgeTable(), other.getEdgeTable());
  expectSameTrees(one, other);
}

/// Of enough triangles for several threads, and with all that has to be repaired.
std::vector<NamedMesh> makeLargeMeshes()
{
  TriangleSoup scrambled = makeTorus(1.0, 0.4, 300, 200);
  turnRandomly(scrambled, 1);
  TriangleSoup touching;
  for (int cube = 0; cube < 4000; ++cube)
  {
    append(touching, makeCube(glm::dvec3(cube % 20, cube / 20 % 20, cube / 400), 1.0));
  }
  TriangleSoup twice = makeFlatSquare(150);
  append(twice, makeFlatSquare(150));
  return {{"torus", makeTorus(1.0, 0.4, 300, 200)},
          {"scrambled torus", scrambled},
          {"unshared sphere", makeUnshared(makeSphere(1.0, 200, 150))},
          {"cubes that touch", touching},
          {"square twice", twice},
          {"moebius strip", makeMoebius(20000)},
          {"random soup", makeRandomSoup(40000, 1)}};
}

std::vector<SEDGeometryJob> makeJobs(const std::vector<NamedMesh>& meshes)
{
  std::vector<SEDGeometryJob> jobs;
  for (const NamedMesh& mesh : meshes)
  {
    jobs.emplace_back().soup = mesh.soup;
  }
  return jobs;
}

std::vector<NamedMesh> makeDamagedMeshes()
{
  TriangleSoup notFinite = makeCube();
  notFinite.points[3].y = std::numeric_limits<double>::quiet_NaN();
  TriangleSoup outOfRange = makeCube();
  outOfRange.triangles[5][1] = 99;
  return {{"not finite", notFinite}, {"out of range", outOfRange}, {"empty", {}}};
}

} // namespace

TEST(ParallelBuilding, LargeMeshes_SameBitsWithAnyNumberOfThreads)
{
  for (const NamedMesh& mesh : makeLargeMeshes())
  {
    for (const bool copiesCountOnce : {false, true})
    {
      SCOPED_TRACE(mesh.name);
      SEDGeometryOptions options;
      options.copiesCountOnce = copiesCountOnce;
      const SEDGeometry alone = build(mesh.soup, options);
      for (const std::size_t threads : {1, 2, 7})
      {
        options.parallelFor = makeThreads(threads);
        expectSame(build(mesh.soup, options), alone);
      }
    }
  }
}

TEST(ParallelBuilding, ManyMeshes_EachAsIfBuiltByItself)
{
  std::vector<NamedMesh> meshes = makeAllMeshes();
  meshes.push_back({"large enough for all threads", makeTorus(1.0, 0.4, 520, 260)});
  for (const std::size_t threads : {1, 2, 7})
  {
    std::vector<SEDGeometryJob> jobs = makeJobs(meshes);
    buildSEDGeometries(jobs, makeThreads(threads));
    for (std::size_t place = 0; place < meshes.size(); ++place)
    {
      SCOPED_TRACE(meshes[place].name);
      ASSERT_TRUE(jobs[place].geometry.has_value());
      EXPECT_EQ(jobs[place].error, "");
      expectSame(*jobs[place].geometry, build(meshes[place].soup));
    }
  }
}

TEST(ParallelBuilding, DamagedMeshesAmongOthers_TellTheirOwnErrors)
{
  std::vector<NamedMesh> meshes;
  for (int round = 0; round < 20; ++round)
  {
    for (const NamedMesh& mesh : makeDamagedMeshes())
    {
      meshes.push_back({"cube", makeCube()});
      meshes.push_back(mesh);
    }
  }
  std::vector<SEDGeometryJob> jobs = makeJobs(meshes);
  buildSEDGeometries(jobs, makeThreads(4));
  for (std::size_t place = 0; place < meshes.size(); ++place)
  {
    SCOPED_TRACE(meshes[place].name);
    std::string error;
    const bool built = buildSEDGeometry(meshes[place].soup, {}, error).has_value();
    EXPECT_EQ(built, meshes[place].name == "cube");
    EXPECT_EQ(jobs[place].geometry.has_value(), built);
    EXPECT_EQ(jobs[place].error, error);
  }
}

TEST(ParallelBuilding, MovedMeshes_TakeOverWhatTheirPreviousHas)
{
  const TriangleSoup soup = makeTorus(1.0, 0.4, 520, 260);
  const SEDGeometry previous = build(soup);
  std::vector<SEDGeometryJob> jobs(2);
  for (SEDGeometryJob& job : jobs)
  {
    job.soup = soup;
    job.options.previous = &previous;
  }
  jobs[0].soup.points[0] *= 1.01;
  jobs[1].soup.triangles.pop_back();
  buildSEDGeometries(jobs, makeThreads(3));
  EXPECT_TRUE(isSameMeshMoved(*jobs[0].geometry, previous));
  EXPECT_FALSE(isSameMeshMoved(*jobs[1].geometry, previous));
}

} // namespace shadow::test
