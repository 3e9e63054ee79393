#ifndef shadow_examples_StlGrammar_h
#define shadow_examples_StlGrammar_h

#include <cstddef>
#include <string>
#include <string_view>

#include "PointRange.h"

namespace shadow::examples
{

/// The first word of a line of a text STL in lower case, as case does not matter.
std::string getStlWord(std::string_view line);

/// Whether a line that begins with this word says nothing; empty lines are such, too.
bool isStlComment(const std::string& word);

/// Follows a text STL line by line. vtkSTLReader takes a text in which something is wrong for a binary file
/// from VTK 9.6 on, so that its message is not about what is wrong.
class StlGrammar
{
public:
  /// @throws UserError that names the line, for one that may not stand where it does or that is no finite point
  void take(std::string_view line);

  /// @throws UserError when there is no solid, or the last one does not end
  void finish() const;

  bool hasComments() const { return this->comments; } ///< also between the lines, where the reader knows none
  const PointRange& getRange() const { return this->range; }

private:
  enum class State
  {
    Solid,
    Facet,
    Loop,
    Vertex,
    EndLoop,
    EndFacet
  };

  void takeVertex(std::string_view line);
  [[noreturn]] void refuse(const std::string& why) const;

  State state = State::Solid; ///< what comes next
  std::size_t number = 0;     ///< of the line, from 1
  std::size_t solids = 0;
  std::size_t vertices = 0;
  bool comments = false;
  PointRange range;
};

} // namespace shadow::examples

#endif
