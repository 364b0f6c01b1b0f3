/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "cellModel.H"
#include "cellShape.H"
#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "sigFpe.H"
#include "wallPolyPatch.H"

#include <cstdlib>
#include <filesystem>

using namespace Foam;

namespace
{

fileName makeDirectory()
{
    std::string path =
        (std::filesystem::temp_directory_path()/"foamTest.XXXXXX").string();
    if (!mkdtemp(&path[0]))
    {
        throw std::runtime_error("cannot make " + path);
    }
    return fileName(path);
}


std::string dictionaryFile(const std::string& object, const std::string& text)
{
    return
        "FoamFile { version 2.0; format ascii; class dictionary; object "
      + object + "; }\n" + text + "\n";
}


const char* const linearSchemes =
    "ddtSchemes { default Euler; }"
    "gradSchemes { default Gauss linear; }"
    "divSchemes { default Gauss linear; }"
    "laplacianSchemes { default Gauss linear corrected; }"
    "interpolationSchemes { default linear; }"
    "snGradSchemes { default corrected; }";


//- What the ranks other than the master say: only their failures
class failurePrinter
:
    public ::testing::EmptyTestEventListener
{
    void OnTestPartResult(const ::testing::TestPartResult& result) override
    {
        if (result.failed())
        {
            Perr<< result.file_name() << ':' << result.line_number() << ": "
                << result.message() << endl;
        }
    }
};

}


Foam::dictionary foamTest::dict(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


foamTest::emptyCase::emptyCase
(
    const std::string& controlDict,
    const std::string& fvSolution
)
:
    path_(makeDirectory())
{
    writeFile
    (
        "system/fvSchemes",
        dictionaryFile("fvSchemes", linearSchemes)
    );
    writeFile
    (
        "system/fvSolution",
        dictionaryFile("fvSolution", fvSolution)
    );

    time_.reset
    (
        new Time
        (
            dict
            (
                "startFrom startTime; startTime 0; stopAt endTime; endTime 1;"
                "deltaT 1; writeControl timeStep; writeInterval 1000;"
              + controlDict
            ),
            path_.path(),
            path_.name(),
            "system",
            "constant",
            false,
            false
        )
    );
}


foamTest::emptyCase::~emptyCase()
{
    rmDir(path_);
}


void foamTest::emptyCase::writeFile
(
    const fileName& file,
    const std::string& text
) const
{
    mkDir((path_/file).path());
    OFstream(path_/file)() << text.c_str();
}


foamTest::blockCase::blockCase
(
    const Vector<label>& n,
    const boundBox& bounds,
    const map& moved,
    const word& frontAndBack,
    const std::string& controlDict,
    const std::string& fvSolution
)
:
    emptyCase(controlDict, fvSolution)
{
    const label nx = n.x();
    const label ny = n.y();
    const label nz = n.z();
    const auto vertex = [=](const label i, const label j, const label k)
    {
        return i + (nx + 1)*(j + (ny + 1)*k);
    };

    pointField points((nx + 1)*(ny + 1)*(nz + 1));
    for (label k = 0; k <= nz; ++k)
    for (label j = 0; j <= ny; ++j)
    for (label i = 0; i <= nx; ++i)
    {
        const point p
        (
            bounds.min().x() + (bounds.max().x() - bounds.min().x())*i/nx,
            bounds.min().y() + (bounds.max().y() - bounds.min().y())*j/ny,
            bounds.min().z() + (bounds.max().z() - bounds.min().z())*k/nz
        );
        points[vertex(i, j, k)] = moved ? moved(p) : p;
    }

    enum { left, right, bottom, top, back, front, nPatches };
    List<DynamicList<face>> faces(nPatches);

    cellShapeList cells(nx*ny*nz);
    for (label k = 0; k < nz; ++k)
    for (label j = 0; j < ny; ++j)
    for (label i = 0; i < nx; ++i)
    {
        const label v[8] =
        {
            vertex(i, j, k),
            vertex(i+1, j, k),
            vertex(i+1, j+1, k),
            vertex(i, j+1, k),
            vertex(i, j, k+1),
            vertex(i+1, j, k+1),
            vertex(i+1, j+1, k+1),
            vertex(i, j+1, k+1)
        };
        const auto side = [&](label a, label b, label c, label d)
        {
            return face(labelList({v[a], v[b], v[c], v[d]}));
        };

        cells[i + nx*(j + ny*k)] = cellShape
        (
            cellModel::ref(cellModel::HEX),
            labelList(UList<label>(const_cast<label*>(v), 8))
        );

        if (k == 0) faces[back].append(side(0, 3, 2, 1));
        if (k == nz - 1) faces[front].append(side(4, 5, 6, 7));
        if (i == 0) faces[left].append(side(0, 4, 7, 3));
        if (i == nx - 1) faces[right].append(side(1, 2, 6, 5));
        if (j == 0) faces[bottom].append(side(0, 1, 5, 4));
        if (j == ny - 1) faces[top].append(side(3, 7, 6, 2));
    }

    faceListList patchFaces(nPatches);
    forAll(patchFaces, patchi)
    {
        patchFaces[patchi].transfer(faces[patchi]);
    }

    const word& wall = wallPolyPatch::typeName;

    // v1912 has no fvMesh from cell shapes
    const polyMesh shapes
    (
        IOobject
        (
            "shapes",
            time().constant(),
            time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        std::move(points),
        cells,
        patchFaces,
        wordList({"left", "right", "bottom", "top", "back", "front"}),
        wordList({wall, wall, wall, wall, frontAndBack, frontAndBack}),
        "defaultFaces",
        wall,
        wordList(nPatches)
    );

    mesh_.reset
    (
        new fvMesh
        (
            // NO_READ would leave fvSchemes and fvSolution unread
            IOobject
            (
                polyMesh::defaultRegion,
                time().constant(),
                time(),
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE
            ),
            pointField(shapes.points()),
            faceList(shapes.faces()),
            labelList(shapes.faceOwner()),
            labelList(shapes.faceNeighbour()),
            false
        )
    );

    List<polyPatch*> patches(shapes.boundaryMesh().size());
    forAll(patches, patchi)
    {
        patches[patchi] =
            shapes.boundaryMesh()[patchi].clone(mesh_->boundaryMesh()).ptr();
    }
    mesh_->addFvPatches(patches, false);
}


int main(int argc, char* argv[])
{
    ::testing::InitGoogleTest(&argc, argv);

    const bool parallel = argc > 1 && std::string(argv[1]) == "-parallel";
    if (parallel)
    {
        UPstream::init(argc, argv, false);
        if (!Pstream::master())
        {
            auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
            delete listeners.Release(listeners.default_result_printer());
            listeners.Append(new failurePrinter);
        }
    }

    sigFpe::set(false);
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    int failed = RUN_ALL_TESTS();

    if (parallel)
    {
        reduce(failed, maxOp<int>());
        UPstream::exit(failed);
    }
    return failed;
}
