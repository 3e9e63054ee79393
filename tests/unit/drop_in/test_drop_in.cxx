#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "DropInCase.h"

namespace shadow::test
{

namespace
{

std::vector<Row> concatenate(const std::vector<std::vector<Row>>& tables)
{
  std::vector<Row> all;
  for (const std::vector<Row>& rows : tables)
  {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

std::vector<Row> allRows()
{
  return concatenate({surfaceRows(), translucentRows(), propRows(), overlayRows(), settingRows(),
                      windowRows(), treeRows(), filterRows()});
}

// What surfaces look like is nothing to a selection, and VTK's filters do not let one through.
std::vector<Row> selectableRows()
{
  return concatenate({translucentRows(), propRows(), overlayRows(), settingRows(), windowRows(), treeRows()});
}

std::string nameOf(const testing::TestParamInfo<Row>& info)
{
  return info.param.name;
}

/// How many pixels of a row may differ, drawn in one way.
std::size_t countKnown(const Row& row, Way way)
{
  std::size_t known = 0;
  for (const KnownDifference& difference : knownDifferences())
  {
    const auto& rows = difference.rows;
    const bool isOne = std::find(rows.begin(), rows.end(), row.name) != rows.end();
    known += isOne && (difference.ways & way) != 0 ? difference.pixels : 0;
  }
  return known;
}

} // namespace

class DropIn : public testing::TestWithParam<Row>
{
public:
  /// Draws a row with ours and holds it against VTK's pictures, where it is to be drawn in this way.
  static void expectSame(const Row& row, const Pictures& plain, Way way, bool flat = false)
  {
    if ((row.ways & way) == 0)
    {
      return;
    }
    const Pictures ours = draw(row, &way, flat);
    const std::size_t known = countKnown(row, way);
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      const Difference difference = compare(plain[i], ours[i], way == Additive ? countRoundings(row) : 0);
      EXPECT_LE(difference.colour, known) << toString(way) << ", picture " << i + 1 << ": " << difference;
      EXPECT_EQ(difference.alpha + difference.depth, 0U) << toString(way) << ": " << difference;
    }
  }
};

// A pass that has nothing to add to a scene leaves VTK's own picture of it as it is, to the bit. Lights that
// are added up one by one are each rounded to 1 / 255.
TEST_P(DropIn, NothingToAdd_PictureIsVTKs)
{
  const Row& row = GetParam();
  const Pictures plain = draw(row, nullptr);
  for (const Way way : {Mask, Additive, LinesOff, LinesOffOverMask})
  {
    expectSame(row, plain, way);
  }
}

// Where nothing casts, the mask is that of surfaces that look away from a light, which VTK leaves dark, too.
TEST_P(DropIn, NoCasters_FlatSurfaces_PictureIsVTKs)
{
  expectSame(GetParam(), draw(GetParam(), nullptr, true), NoCasters, true);
}

// Outside of shadows the picture is VTK's with shadows, too.
TEST_P(DropIn, WithShadows_PictureIsVTKsOutsideOfThem)
{
  if ((GetParam().ways & Shadowed) != 0)
  {
    const Picture plain = draw(GetParam(), nullptr)[0];
    const Difference difference = compare(plain, drawShadowed(GetParam(), plain));
    EXPECT_TRUE(difference.none()) << difference;
  }
}

class DropInTakenOff : public testing::TestWithParam<Row>
{
};

// Passes leave nothing behind.
TEST_P(DropInTakenOff, BothPasses_PictureIsVTKs)
{
  const Difference difference =
      compare(draw(GetParam(), nullptr)[1], drawAfter(GetParam(), LinesOffOverMask));
  EXPECT_TRUE(difference.none()) << difference;
}

class DropInSelection : public testing::TestWithParam<Row>
{
};

// Selecting goes the way it goes without a pass, wherever ours hangs.
TEST_P(DropInSelection, AnyUse_FindsWhatVTKFinds)
{
  if ((GetParam().ways & Selecting) == 0)
  {
    return;
  }
  Row alone = GetParam();
  alone.attach = nullptr;
  const std::vector<int> plain = pick(alone, nullptr);
  ASSERT_FALSE(plain.empty());
  for (const Way way : {Mask, LinesOff})
  {
    const std::vector<int> ours = pick(GetParam(), &way);
    std::size_t different = plain.size() == ours.size() ? 0 : plain.size() / 2;
    for (std::size_t i = 0; i < std::min(plain.size(), ours.size()); i += 2)
    {
      different += plain[i] != ours[i] || plain[i + 1] != ours[i + 1] ? 1 : 0;
    }
    EXPECT_EQ(different, 0U) << toString(way) << ": pixels, of " << plain.size() / 2;
  }
}

// A row that is renamed must not be tested less, nor one be drawn in another's place.
TEST(DropInTable, Names_AreOfOneRowEach)
{
  std::multiset<std::string> names;
  for (const Row& row : allRows())
  {
    names.insert(row.name);
    EXPECT_EQ(names.count(row.name), 1U) << row.name;
  }
  for (const KnownDifference& difference : knownDifferences())
  {
    for (const std::string& row : difference.rows)
    {
      EXPECT_EQ(names.count(row), 1U) << "of a known difference: " << row;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, DropIn, testing::ValuesIn(allRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Table, DropInTakenOff,
                         testing::ValuesIn(concatenate({surfaceRows(), translucentRows(), propRows()})),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Table, DropInSelection, testing::ValuesIn(selectableRows()), nameOf);

} // namespace shadow::test
