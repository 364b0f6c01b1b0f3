/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "mathematicalConstants.H"
#include "planarCells.H"
#include "spatialCells.H"
#include "voidFractionMethod.H"
#include "surfaceFields.H"
#include "volFields.H"

using namespace Foam;

namespace
{

constexpr scalar pi = constant::mathematical::pi;

point warped(const point& p)
{
    return p + 0.03*vector(std::sin(5*p.y()), std::sin(4*p.z()), std::sin(6*p.x()));
}

// Cells of discs or of spheres in a cube of side 1, with warped faces in space
class Cells
:
    public ::testing::TestWithParam<label>
{
protected:

    const bool planar_ = GetParam() == 2;

    foamTest::blockCase case_
    {
        Vector<label>(6, 5, planar_ ? 1 : 4),
        boundBox(point::zero, point::one),
        planar_ ? foamTest::blockCase::map(nullptr) : warped,
        planar_ ? "empty" : "wall"
    };

    std::unique_ptr<planarMesh> plane_
    {
        planar_ ? new planarMesh(case_.mesh()) : nullptr
    };

    std::unique_ptr<grainCells> cells_
    {
        planar_
      ? static_cast<grainCells*>(new planarCells(*plane_))
      : new spatialCells(case_.mesh())
    };

    const point centre_{0.52, 0.47, 0.5};

    scalar volume(const scalar r) const
    {
        return planar_ ? pi*sqr(r) : 4.0/3.0*pi*pow3(r);
    }

    grainBodies sphere(const point& centre, const scalar radius) const
    {
        return
        {
            pointField(1, centre), scalarField(1, radius), labelList({0, 1}),
            List<grainMember>(1, grainMember{centre, radius})
        };
    }

    overlapList map(const std::string& type, const grainBodies& grains) const
    {
        overlapList overlaps;
        overlaps.clear();
        voidFractionMethod::New(foamTest::dict("type " + type + ";"), *cells_)
            ->map(grains, overlaps);
        return overlaps;
    }
};

INSTANTIATE_TEST_SUITE_P
(
    Of, Cells, ::testing::Values(2, 3),
    [](const auto& info) { return info.param == 2 ? "Discs" : "Spheres"; }
);


vector moment(const overlapList& overlaps)
{
    vector sum(Zero);
    for (label k = 0; k < overlaps.size(); ++k)
    {
        sum += overlaps.volume[k]*overlaps.arm[k];
    }
    return sum;
}

}


TEST_P(Cells, HoldTheVolumeOfAGrain)
{
    for (const scalar r : {1e-3, 0.05, 0.3})
    {
        EXPECT_NEAR(cells_->volume(r)/volume(r), 1, 1e-14);
        const overlapList overlaps(map("exactOverlap", sphere(centre_, r)));
        EXPECT_EQ(overlaps.nGrains(), 1);
        EXPECT_NEAR(sum(overlaps.volume)/volume(r), 1, 1e-12);
        EXPECT_LE(mag(moment(overlaps)), 1e-12*r*volume(r));
        EXPECT_TRUE(cells_->isWithinBounds({centre_, r}));
    }
    EXPECT_FALSE(cells_->isWithinBounds({point(0.9, 0.5, 0.5), 0.2}));
}


TEST_P(Cells, HoldWhatMembersOfAClusterFillTogether)
{
    // Two equal ones, the centre of each on the other's surface
    const scalar r = 0.2;
    const vector apart(r*vector(0.6, 0.8, 0));
    grainBodies pair(sphere(centre_, r));
    pair.start = labelList({0, 2});
    pair.member = List<grainMember>
    ({
        {centre_ - 0.5*apart, r}, {centre_ + 0.5*apart, r}
    });
    const overlapList overlaps(map("exactOverlap", pair));

    const scalar lens =
        planar_ ? sqr(r)*(2*pi/3 - std::sqrt(3.0)/2) : 5*pi/12*pow3(r);
    EXPECT_NEAR(sum(overlaps.volume), 2*volume(r) - lens, 1e-13);
    EXPECT_LE(mag(moment(overlaps)), 1e-13);
}


TEST_P(Cells, AreFoundFromWhereAGrainWas)
{
    grainBodies grain(sphere(centre_, 0.01));
    overlapList overlaps(map("exactOverlap", grain));
    const auto method(voidFractionMethod::New(foamTest::dict("type exactOverlap;"), *cells_));
    for (label step = 0; step < 30; ++step)
    {
        grain = sphere(grain.centre[0] + vector(0.011, 0.007, planar_ ? 0 : 0.009), 0.01);
        method->map(grain, overlaps);
        const overlapList fresh(map("exactOverlap", grain));
        EXPECT_EQ(overlaps.cell, fresh.cell);
        EXPECT_EQ(overlaps.volume, fresh.volume);
        EXPECT_EQ(overlaps.arm, fresh.arm);
    }
}


TEST_P(Cells, HaveACentroidOnTheirFacesInCommon)
{
    const fvMesh& mesh = case_.mesh();
    const scalar r = 0.07;

    const overlapList inside(map("centroid", sphere(mesh.C()[7], r)));
    ASSERT_EQ(inside.size(), 1);
    EXPECT_EQ(inside.cell[0], 7);
    EXPECT_NEAR(inside.volume[0]/volume(r), 1, 1e-12);
    EXPECT_EQ(inside.arm[0], vector(Zero));

    label facei = 0;
    while (mesh.faceOwner()[facei] != 7)
    {
        ++facei;
    }
    const overlapList between(map("centroid", sphere(mesh.Cf()[facei], r)));
    ASSERT_EQ(between.size(), 2);
    // A face may be warped, by much less than a thousandth of the radius
    EXPECT_NEAR(between.volume[0]/between.volume[1], 1, 0.1);
    EXPECT_NEAR(sum(between.volume)/volume(r), 1, 1e-12);
}


TEST_P(Cells, HaveTheirPartOfTheSatellitePoints)
{
    // The exact overlap with the cell of the centre, at the rate of even points
    const scalar r = 0.15;
    const grainBodies grain(sphere(centre_, r));
    const auto inCells = [&](const overlapList& overlaps)
    {
        scalarField volumes(case_.mesh().nCells(), Zero);
        for (label k = 0; k < overlaps.size(); ++k)
        {
            volumes[overlaps.cell[k]] += overlaps.volume[k]/volume(r);
        }
        return volumes;
    };
    const scalarField exact(inCells(map("exactOverlap", grain)));
    for (const label pairs : {1, 100, 10000})
    {
        const overlapList points
        (
            map("satellitePoints; pairs " + std::to_string(pairs), grain)
        );
        EXPECT_NEAR(sum(points.volume)/volume(r), 1, 1e-12);
        EXPECT_LE(mag(moment(points)), 1e-12*r*volume(r));
        EXPECT_LE(max(mag(inCells(points) - exact)), 1/std::sqrt(2.0*pairs));
    }
}


TEST_P(Cells, HaveTheirPartOfTheKernel)
{
    const fvMesh& mesh = case_.mesh();
    const scalar r = 0.1, b = 0.15;
    const overlapList overlaps(map("gaussianKernel; width 0.75", sphere(centre_, r)));
    EXPECT_GT(overlaps.size(), 8);
    EXPECT_NEAR(sum(overlaps.volume)/volume(r), 1, 1e-13);
    const auto kernel = [&](const label celli)
    {
        return mesh.V()[celli]*std::exp(-magSqr(mesh.C()[celli] - centre_)/sqr(b));
    };
    const scalar scale = overlaps.volume[0]/kernel(overlaps.cell[0]);
    for (label k = 0; k < overlaps.size(); ++k)
    {
        EXPECT_NEAR(overlaps.volume[k]/kernel(overlaps.cell[k])/scale, 1, 1e-12);
    }

    // None within reach of a small one
    const overlapList small(map("gaussianKernel; width 0.75", sphere(centre_, 1e-4)));
    EXPECT_NEAR(sum(small.volume)/volume(1e-4), 1, 1e-12);
}


TEST(VoidFraction, RefusesWhatMakesNoSense)
{
    foamTest::planarCase planar(2, 2);
    const planarMesh plane(planar.mesh());
    const planarCells cells(plane);
    const auto make = [&](const std::string& entries)
    {
        return voidFractionMethod::New(foamTest::dict(entries), cells);
    };
    EXPECT_FOAM_ERROR(make("type exact;"), "exactOverlap");
    EXPECT_FOAM_ERROR(make("type satellitePoints; pairs 0;"), "'pairs'");
    EXPECT_FOAM_ERROR(make("type satellitePoints; points 3;"), "'points'");
    EXPECT_FOAM_ERROR(make("type gaussianKernel;"), "width");
    EXPECT_FOAM_ERROR(make("type gaussianKernel; width -1;"), "'width'");
}


TEST(SpatialCells, FollowTheMesh)
{
    foamTest::blockCase block(Vector<label>(4, 4, 4));
    const spatialCells cells(block.mesh());
    const grainMember sphere{point(0.4, 0.5, 0.6), 0.3};
    overlapList before, after;
    before.clear();
    after.clear();

    cells.appendOverlaps(sphere, -1, before);
    pointField points(block.mesh().points());
    const vector shift(10, 20, 30);
    points += shift;
    block.mesh().movePoints(points);

    cells.appendOverlaps(sphere, -1, after);
    EXPECT_EQ(after.size(), 0);
    cells.appendOverlaps({sphere.centre + shift, sphere.radius}, -1, after);
    ASSERT_EQ(after.cell, before.cell);
    EXPECT_NEAR(sum(after.volume)/sum(before.volume), 1, 1e-13);
}


TEST(ParallelSpatialCells, MayBeNoneOfARank)
{
    // Each rank has its own mesh: the sphere is in that of rank 0 alone
    const scalar x = 5*Pstream::myProcNo();
    foamTest::blockCase block
    (
        Vector<label>(2, 2, 2), boundBox(point(x, 0, 0), point(x + 1, 1, 1))
    );
    const spatialCells cells(block.mesh());
    overlapList overlaps;
    overlaps.clear();
    cells.appendOverlaps({point(0.5, 0.5, 0.5), 0.4}, -1, overlaps);
    EXPECT_EQ(overlaps.size(), Pstream::master() ? 8 : 0);
}
