#include "StlGrammar.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "TextLines.h"
#include "UserError.h"

namespace shadow::examples
{

namespace
{

/// By state.
constexpr std::array<const char*, 6> expected = {"solid", "facet", "outer", "vertex", "endloop", "endfacet"};

} // namespace

std::string getStlWord(std::string_view line)
{
  std::string word(nextWord(line));
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

bool isStlComment(const std::string& word)
{
  return word.empty() || word[0] == '#' || word[0] == ';' || word.rfind("//", 0) == 0;
}

void StlGrammar::take(std::string_view line)
{
  ++this->number;
  const std::string word = getStlWord(line);
  if (isStlComment(word))
  {
    this->comments = this->comments || !word.empty();
    return;
  }
  if (this->state == State::Facet && word == "endsolid")
  {
    this->state = State::Solid;
    return;
  }
  if (this->state == State::Facet && word == "color")
  {
    return;
  }
  const char* const wanted = expected[static_cast<std::size_t>(this->state)];
  if (word != wanted)
  {
    this->refuse("\"" + std::string(wanted) + "\" expected, not \"" + word.substr(0, 20) + "\"");
  }
  switch (this->state)
  {
  case State::Solid:
    ++this->solids;
    this->state = State::Facet;
    break;
  case State::Facet:
    this->state = State::Loop;
    break;
  case State::Loop:
    this->state = State::Vertex;
    break;
  case State::Vertex:
    this->takeVertex(line);
    break;
  case State::EndLoop:
    this->state = State::EndFacet;
    break;
  case State::EndFacet:
    this->state = State::Facet;
    break;
  }
}

void StlGrammar::takeVertex(std::string_view line)
{
  nextWord(line);
  std::array<double, 3> point{};
  ++this->vertices;
  for (double& value : point)
  {
    switch (examine(nextWord(line), value))
    {
    case Number::None:
      this->refuse("a point needs three numbers");
    case Number::NotFinite:
      this->refuse("point " + std::to_string(this->vertices) + " is not finite");
    case Number::Finite:
      break;
    }
  }
  this->range.add(point);
  if (this->vertices % 3 == 0)
  {
    this->state = State::EndLoop;
  }
}

void StlGrammar::finish() const
{
  if (this->state != State::Solid || this->solids == 0)
  {
    const char* const wanted =
        this->state == State::Facet ? "endsolid" : expected[static_cast<std::size_t>(this->state)];
    throw UserError("ends where \"" + std::string(wanted) + "\" is expected");
  }
}

void StlGrammar::refuse(const std::string& why) const
{
  throw UserError("line " + std::to_string(this->number) + ": " + why);
}

} // namespace shadow::examples
