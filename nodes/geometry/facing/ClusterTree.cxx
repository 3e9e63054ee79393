#include "ClusterTree.h"

#include <algorithm>
#include <cstring>

#include "Avx2.h"
#include "Prefetch.h"

namespace shadow
{

/// One call of classify(). Words that face alike one after the other are written together.
struct ClusterTree::Walk
{
  const ScaledLight& light;
  Sides (*evaluate)(const Group& nodes, const ScaledLight& light);
  std::uint64_t* towards;
  std::uint64_t* away;
  std::size_t runBegin = 0;
  std::size_t runEnd = 0;
  bool runTowards = false;

  void add(std::size_t first, std::size_t end, bool isTowards)
  {
    if (first != this->runEnd || isTowards != this->runTowards)
    {
      this->flush();
      this->runBegin = first;
      this->runTowards = isTowards;
    }
    this->runEnd = end;
  }

  void flush() const
  {
    const std::size_t count = this->runEnd - this->runBegin;
    std::memset(this->towards + this->runBegin, this->runTowards ? 0xff : 0, 8 * count);
    std::memset(this->away + this->runBegin, this->runTowards ? 0 : 0xff, 8 * count);
  }
};

namespace
{

constexpr auto units = static_cast<float>(PlaneBlock::unitsInOne);

/// What bounds have to pass for all planes of a node to have the sign of the exact ones, in units.
///
/// With u, e and S as in ScaledLight: the planes are off by (u / 2 + 1 e) S, the light by 1 e S, relative to
/// the centre by 3 e S, evaluating adds 8 e (|x| + |y| + |z| + 3 |w|), as offsets are 1 at most; and a corner
/// at the light is within 1 e S. The sum is below (u / 2 + 33 e) S, which is 289 e S, and the bound for one
/// plane 272 e S.
float getBound(const ScaledLight& light)
{
  return 1.125f * units * light.bound;
}

/// Each of four bits as 16 of them: a word of FacingBits from bits of its quarters.
std::uint64_t widen(unsigned int quarters)
{
  std::uint64_t word = 0;
  for (unsigned int quarter = 0; quarter < 4; ++quarter)
  {
    word |= (std::uint64_t{0xffff} << 16 * quarter) * (quarters >> quarter & 1u);
  }
  return word;
}

} // namespace

void ClusterTree::classify(const ScaledLight& light, FacingBits& towards, FacingBits& away,
                           std::vector<Quarters>& mixed, InstructionSet set) const
{
  static_cast<void>(set);
  if (this->words == 0)
  {
    return;
  }
  // Level by level, since what is next on a level is known, and fetched, before its turn.
  constexpr std::size_t ahead = 6;
  Walk walk{light, evaluate, towards.data(), away.data()};
#ifdef SHADOW_HAS_AVX2
  if (set == InstructionSet::Avx2)
  {
    walk.evaluate = evaluateAvx2;
  }
#endif
  std::vector<std::uint32_t> groups = {0};
  std::vector<std::uint32_t> below;
  for (std::size_t level = this->levels.size(); level-- > 0;)
  {
    for (std::size_t index = 0; index < groups.size(); ++index)
    {
      if (index + ahead < groups.size())
      {
        prefetch(&this->levels[level][groups[index + ahead]], sizeof(Group));
      }
      if (level > 0)
      {
        this->visit(level, groups[index], walk, below);
      }
      else
      {
        this->visitClusters(groups[index], walk, mixed);
      }
    }
    groups.swap(below);
    below.clear();
  }
  walk.flush();
  towards.clearBeyondEnd();
  away.clearBeyondEnd();
}

/// Which of eight nodes face the light as one?
ClusterTree::Sides ClusterTree::evaluate(const Group& nodes, const ScaledLight& light)
{
  const float step = light.w / units;
  const float bound = getBound(light);
  const std::array<float, 3> towards = {light.x, light.y, light.z};
  Sides sides;
  for (std::size_t lane = 0; lane < fan; ++lane)
  {
    const float atLower = static_cast<float>(nodes.offsetLower[lane]) * light.w;
    const float atUpper = static_cast<float>(nodes.offsetUpper[lane]) * light.w;
    float lower = std::min(atLower, atUpper);
    float upper = std::max(atLower, atUpper);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const float arm = towards[axis] - step * static_cast<float>(nodes.centre[axis][lane]);
      const float first = static_cast<float>(nodes.normalLower[axis][lane]) * arm;
      const float second = static_cast<float>(nodes.normalUpper[axis][lane]) * arm;
      lower += std::min(first, second);
      upper += std::max(first, second);
    }
    sides.towards |= static_cast<unsigned int>(lower > bound) << lane;
    sides.away |= static_cast<unsigned int>(upper < -bound) << lane;
  }
  return sides;
}

#ifdef SHADOW_HAS_AVX2

namespace
{

SHADOW_INLINE_AVX2 __m256 loadLanes(const std::array<std::int16_t, 8>& lanes)
{
  return _mm256_cvtepi32_ps(
      _mm256_cvtepi16_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(lanes.data()))));
}

} // namespace

/// The same, eight at a time.
SHADOW_TARGET_AVX2 ClusterTree::Sides ClusterTree::evaluateAvx2(const Group& nodes, const ScaledLight& light)
{
  const __m256 step = _mm256_set1_ps(light.w / units);
  const __m256 w = _mm256_set1_ps(light.w);
  const __m256 atLower = _mm256_mul_ps(loadLanes(nodes.offsetLower), w);
  const __m256 atUpper = _mm256_mul_ps(loadLanes(nodes.offsetUpper), w);
  __m256 lower = _mm256_min_ps(atLower, atUpper);
  __m256 upper = _mm256_max_ps(atLower, atUpper);
  const std::array<float, 3> towards = {light.x, light.y, light.z};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const __m256 arm =
        _mm256_sub_ps(_mm256_set1_ps(towards[axis]), _mm256_mul_ps(step, loadLanes(nodes.centre[axis])));
    const __m256 first = _mm256_mul_ps(loadLanes(nodes.normalLower[axis]), arm);
    const __m256 second = _mm256_mul_ps(loadLanes(nodes.normalUpper[axis]), arm);
    lower = _mm256_add_ps(lower, _mm256_min_ps(first, second));
    upper = _mm256_add_ps(upper, _mm256_max_ps(first, second));
  }
  const float bound = getBound(light);
  Sides sides;
  sides.towards =
      static_cast<unsigned int>(_mm256_movemask_ps(_mm256_cmp_ps(lower, _mm256_set1_ps(bound), _CMP_GT_OQ)));
  sides.away =
      static_cast<unsigned int>(_mm256_movemask_ps(_mm256_cmp_ps(upper, _mm256_set1_ps(-bound), _CMP_LT_OQ)));
  return sides;
}

#endif

/// Writes the words of a group's children that face alike; not for clusters.
/// @param mixed  the other children are appended, by their number on their level
void ClusterTree::visit(std::size_t level, std::size_t group, Walk& walk,
                        std::vector<std::uint32_t>& mixed) const
{
  const Sides sides = walk.evaluate(this->levels[level][group], walk.light);
  std::size_t span = wordsOfGroup; // words of a child
  for (std::size_t below = 1; below < level; ++below)
  {
    span *= fan;
  }
  for (std::size_t child = fan * group; child < std::min(fan * group + fan, this->levels[level - 1].size());
       ++child)
  {
    const unsigned int bit = 1u << child % fan;
    if (((sides.towards | sides.away) & bit) != 0)
    {
      walk.add(child * span, std::min((child + 1) * span, this->words), (sides.towards & bit) != 0);
    }
    else
    {
      mixed.push_back(static_cast<std::uint32_t>(child));
    }
  }
}

/// The same for a group of clusters, whose bits are written in any case.
void ClusterTree::visitClusters(std::size_t group, Walk& walk, std::vector<Quarters>& mixed) const
{
  constexpr unsigned int all = (1u << quartersOfWord) - 1;
  Sides sides = walk.evaluate(this->levels[0][group], walk.light);
  const std::size_t firstWord = wordsOfGroup * group;
  for (std::size_t word = firstWord; word < std::min(firstWord + wordsOfGroup, this->words); ++word)
  {
    walk.towards[word] = widen(sides.towards & all);
    walk.away[word] = widen(sides.away & all);
    const std::size_t existing = std::min(this->clusters - quartersOfWord * word, quartersOfWord);
    const unsigned int open = ~(sides.towards | sides.away) & ((1u << existing) - 1);
    if (open != 0)
    {
      // Number by number: what was put together in memory would have to wait for its parts.
      Quarters& quarters = mixed.emplace_back();
      quarters.word = static_cast<std::uint32_t>(word);
      quarters.bits = open;
    }
    sides.towards >>= quartersOfWord;
    sides.away >>= quartersOfWord;
  }
}

} // namespace shadow
