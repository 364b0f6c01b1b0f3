/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    packGrains

Group
    grpGrainPreProcessing

Description
    Make an initial packing of grains and write it as comma-separated values,
    which 'initialGrains { type csv; ... }' of constant/grainProperties reads.

    What is packed stands in system/packGrainsDict; materials, walls and
    contacts are those of constant/grainProperties.

Usage
    \verbatim
    packGrains [OPTION]

      -dict <file>   another dictionary than system/packGrainsDict
    \endverbatim

    Grains are written as they were made, or with 'order spatial' so that
    neighbours in space are near each other in the file and in memory, which
    makes runs with many grains faster.

    See etc/caseDicts/packGrainsDict for an example of every packing.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "OFstream.H"
#include "OSspecific.H"

#include "dictionaryInput.H"
#include "grainChecks.H"
#include "packingReport.H"
#include "nscd/search/SpatialOrder.hpp"

#include <filesystem>

//- The order in which grains are written
template<int D>
std::vector<std::size_t> order
(
    const nscd::Grains<D>& grains,
    const dictionary& dict
)
{
    const word name
    (
        dictionaryInput::getWordOrDefault
        (
            dict, "order", "asMade", {"asMade", "spatial"}
        )
    );
    if (name == "spatial")
    {
        const scalar largest =
            *std::max_element(grains.radius.begin(), grains.radius.end());
        return nscd::spatialOrder<D>(grains.position, 8*largest);
    }
    std::vector<std::size_t> result(grains.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
}



template<int D>
void pack(const fvMesh& mesh, const dictionary& dict)
{
    const grainProperties<D> properties
    (
        mesh, meshObjects::gravity::New(mesh.time()).value()
    );
    const nscd::Grains<D> grains(properties.grains(dict));
    const grainSpace<D>& space = properties.space();

    const grainChecks<D> checks(properties, grains, dict, "type");
    checks.requireInside();
    checks.requireNoOverlap();

    fileName file
    (
        dict.getOrDefault<fileName>("output", "constant/grains.csv")
    );
    if (!file.isAbsolute())
    {
        file = mesh.time().path()/file;
    }
    // What fails is seen when the file is written
    std::error_code ignored;
    std::filesystem::create_directories(file.path(), ignored);

    OFstream os(file);
    os.precision(17);
    const bool heated =
        std::any_of
        (
            grains.temperature.begin(), grains.temperature.end(),
            [](const double t) { return t > 0; }
        );
    os  << "x,y,z,radius,vx,vy,vz,wx,wy,wz,material"
        << (heated ? ",temperature" : "")
        << (grains.clusters.empty() ? "" : ",shape,qw,qx,qy,qz") << nl;
    for (const std::size_t i : order(grains, dict))
    {
        const point x(space.positionInSpace(grains.position[i]));
        const vector v(space.toSpace(grains.velocity[i]));
        const vector w(space.spinInSpace(grains.spin[i]));

        os  << x.x() << ',' << x.y() << ',' << x.z() << ','
            << grains.radius[i] << ','
            << v.x() << ',' << v.y() << ',' << v.z() << ','
            << w.x() << ',' << w.y() << ',' << w.z() << ','
            << properties.materials().names()[grains.material[i]];
        if (heated)
        {
            os  << ',' << grains.temperature[i];
        }
        if (grains.clusters.size())
        {
            const quaternion q
            (
                space.orientationInSpace
                (
                    properties.shapes().ofCentres
                    (
                        grains.shape[i], grains.orientation[i]
                    )
                )
            );
            os  << ',' << properties.shapes().name(grains.shape[i])
                << ',' << q.w() << ',' << q.v().x() << ',' << q.v().y()
                << ',' << q.v().z();
        }
        os  << nl;
    }
    os.flush();
    if (!os.good())
    {
        dictionaryInput::badValue
        (
            dict, "output", file, "a file that can be written, on a disk with room"
        );
    }

    printPacking(properties, grains);
    Info<< nl << "Wrote " << file << nl << nl << "End" << nl << endl;
}


int main(int argc, char *argv[])
{
    argList::addNote("Make an initial packing of grains.");
    argList::noParallel();
    argList::addOption("dict", "file", "Alternative packGrainsDict");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const IOdictionary dict
    (
        IOobject
        (
            args.found("dict")
          ? fileName(args["dict"])
          : fileName(runTime.system()/"packGrainsDict"),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );

    if (isPlanar(mesh))
    {
        pack<2>(mesh, dict);
    }
    else
    {
        pack<3>(mesh, dict);
    }
    return 0;
}
