/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "planarMesh.H"
#include "volFields.H"

#include <set>

using namespace Foam;

namespace
{

typedef Eigen::Vector2d point2;

// Rotations that put the plane x-y into the planes x-z and y-z
point toXZ(const point& p)
{
    return point(p.x(), -p.z(), p.y());
}

point toYZ(const point& p)
{
    return point(p.z(), p.x(), p.y());
}

struct Plane
{
    const char* name;
    foamTest::planarCase::map map;
    point2 of123;
    int across;
};

class PlanarMesh
:
    public ::testing::TestWithParam<Plane>
{
protected:

    foamTest::planarCase case_{7, 5, boundBox(point(-1, 2, 0), point(2, 3, 0.2)), GetParam().map};
    planarMesh plane_{case_.mesh()};
};

INSTANTIATE_TEST_SUITE_P
(
    Of, PlanarMesh,
    ::testing::Values
    (
        Plane{"XY", nullptr, {1, 2}, 2},
        Plane{"XZ", toXZ, {1, 3}, 1},
        Plane{"YZ", toYZ, {2, 3}, 0}
    ),
    [](const auto& info) { return std::string(info.param.name); }
);

}


TEST_P(PlanarMesh, HasItsAxes)
{
    EXPECT_EQ(plane_.toPlane(vector(1, 2, 3)), GetParam().of123);
    EXPECT_EQ(plane_.outOfPlane(vector(1, 2, 3)), GetParam().across + 1);
    EXPECT_EQ(plane_.toPlane(plane_.toSpace({4, 5})), point2(4, 5));
    EXPECT_NEAR(plane_.depth(), 0.2, 1e-15);
    EXPECT_NEAR
    (
        plane_.positionInSpace({4, 5})[GetParam().across],
        GetParam().across == 1 ? -0.1 : 0.1, 1e-15
    );
}


TEST_P(PlanarMesh, TurnsTheFirstAxisTowardsTheSecond)
{
    const vector spin(plane_.spinInSpace(3));
    EXPECT_EQ(plane_.toPlane(spin ^ plane_.toSpace({1, 0})), point2(0, 3));
    EXPECT_EQ(plane_.toSpin(spin), 3);
    EXPECT_FALSE(plane_.spinLeavesPlane(spin));
    EXPECT_TRUE(plane_.spinLeavesPlane(plane_.toSpace({0, 1})));
}


TEST_P(PlanarMesh, SeesCellsAsPolygonsAgainstTheClock)
{
    for (label celli = 0; celli < plane_.nCells(); ++celli)
    {
        ASSERT_EQ(plane_.polygonSize(celli), 4);
        const point2* x = plane_.polygon(celli);
        scalar area = 0;
        for (int i = 0; i < 4; ++i)
        {
            const point2& p = x[i];
            const point2& q = x[(i + 1) % 4];
            area += 0.5*(p.x()*q.y() - p.y()*q.x());
        }
        EXPECT_NEAR(area, 3.0/35, 1e-14);
        EXPECT_NEAR(area*plane_.depth(), case_.mesh().V()[celli], 1e-14);
    }
    EXPECT_NEAR(plane_.cellSizeRange().first(), std::sqrt(3.0/35), 1e-14);
}


TEST_P(PlanarMesh, FindsCells)
{
    for (label celli = 0; celli < plane_.nCells(); ++celli)
    {
        EXPECT_EQ(plane_.findCell(plane_.toPlane(case_.mesh().C()[celli])), celli);
    }
    const Eigen::AlignedBox2d box(plane_.globalDomain());
    EXPECT_EQ(plane_.findCell(box.min() - point2(1e-9, -0.1)), -1);
    EXPECT_EQ(plane_.findCell(box.max() + point2(1e3, 0)), -1);
}


TEST_P(PlanarMesh, PassesEachCellOfABoxOnce)
{
    const auto cellsOf = [&](const Eigen::AlignedBox2d& box)
    {
        std::multiset<label> cells;
        plane_.forCells(box, [&](label celli) { cells.insert(celli); });
        return cells;
    };
    const Eigen::AlignedBox2d all(plane_.globalDomain());
    const auto cells = cellsOf(all);
    EXPECT_EQ(cells.size(), 35u);
    EXPECT_EQ(std::set<label>(cells.begin(), cells.end()).size(), 35u);

    const point2 x(plane_.toPlane(case_.mesh().C()[17]));
    EXPECT_EQ(cellsOf(Eigen::AlignedBox2d(x, x)), std::multiset<label>{17});
}


TEST(PlanarMeshErrors, RefuseCellsThatAreNoPrisms)
{
    foamTest::planarCase tapered
    (
        2, 2, boundBox(point::zero, point::one),
        [](const point& p) { return point(p.x()*(1 + p.z()), p.y(), p.z()); }
    );
    EXPECT_FOAM_ERROR(planarMesh(tapered.mesh()), "one layer of cells");
}


TEST(ParallelPlanarMesh, HasTheSizesOfAllRanks)
{
    foamTest::planarCase own(1 + Pstream::myProcNo(), 1);
    const planarMesh plane(own.mesh());
    const Pair<scalar> size(plane.cellSizeRange());
    EXPECT_NEAR(size.first(), 1/std::sqrt(scalar(Pstream::nProcs())), 1e-14);
    EXPECT_NEAR(size.second(), 1, 1e-14);
}
