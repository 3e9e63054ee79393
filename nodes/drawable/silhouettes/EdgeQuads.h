#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadow
{

/// Five vertices and three triangles for each of a number of edges, as numbers only: a quad and one triangle
/// of a fan, see shaders/sides.vert. One serves all geometries, since number 5 e + c means corner c of edge e
/// in each.
///
/// @par Memory  24 bytes an edge of the largest geometry, and 12 where fans are drawn
class EdgeQuads
{
public:
  EdgeQuads() = default;
  EdgeQuads(const EdgeQuads&) = delete;
  EdgeQuads& operator=(const EdgeQuads&) = delete;

  /// Draws edges 0 to @p edges - 1 with the current program.
  /// @param withFan  the fan's triangles, too
  void draw(std::size_t edges, bool withFan);

  /// What glDrawElementsIndirect() takes, for quads or for fans.
  struct Command
  {
    std::uint32_t indices = 0; ///< indicesOfQuad or indicesOfFan for each edge
    std::uint32_t instances = 1;
    std::uint32_t firstIndex = 0;
    std::uint32_t firstVertex = 0;
    std::uint32_t firstInstance = 0;
  };
  static constexpr std::uint32_t indicesOfQuad = 6;
  static constexpr std::uint32_t indicesOfFan = 3;

  /// The same for as many edges as a buffer on the GPU says. @pre GL 4.0
  ///
  /// @param commands  a buffer with a Command for quads and one for fans at byte @p offset
  /// @param mostEdges  no command asks for more
  void drawIndirect(unsigned int commands, std::size_t offset, std::size_t mostEdges, bool withFan);

  void release(bool contextLost = false);
  std::size_t getMemorySize() const { return this->quads.bytes + this->fans.bytes; }

private:
  /// The triangles of one kind.
  struct Part
  {
    std::vector<std::uint32_t> corners; ///< of one edge, three a triangle
    unsigned int vertexArray = 0;
    unsigned int indexBuffer = 0;
    std::size_t capacity = 0; ///< edges
    std::size_t bytes = 0;

    void bind(std::size_t edges);
    void release(bool contextLost);
  };

  Part quads{{0, 1, 2, 0, 2, 3}};
  Part fans{{4, 3, 2}};
};

} // namespace shadow
