/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"

#include "dictionaryInput.H"
#include "OStringStream.H"
#include "sigFpe.H"
#include "surfaceGaps.H"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace
{

using namespace Foam;

// Why an STL file is not whole, empty if it is
string faultOfSTL(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::stringstream stream;
    stream << is.rdbuf();
    const std::string text(stream.str());

    OStringStream fault;
    if (text.compare(0, 5, "solid") == 0)
    {
        const auto end = text.find_last_not_of(" \t\r\n");
        const auto line = text.find_last_of('\n', end) + 1;
        if (text.find("endsolid", line) == std::string::npos)
        {
            fault << "it does not end with a line 'endsolid'";
        }
        return fault.str();
    }

    constexpr std::size_t header = 84, triangle = 50;
    if (text.size() < header)
    {
        fault
            << "it has " << label(text.size()) << " bytes, fewer than the header";
        return fault.str();
    }
    std::uint32_t n;
    std::copy_n(text.data() + 80, 4, reinterpret_cast<char*>(&n));
    if (text.size() < header + n*triangle)
    {
        fault
            << "it has " << label(text.size()) << " bytes instead of "
            << scalar(header + n*triangle) << " for " << scalar(n)
            << " triangles";
    }
    return fault.str();
}


// Why an OBJ file is not whole, empty if it is
string faultOfOBJ(const fileName& file)
{
    std::ifstream is(file);
    std::string line;
    label nPoints = 0, lineNo = 0;
    while (std::getline(is, line))
    {
        ++lineNo;
        std::istringstream words(line);
        std::string word;
        words >> word;
        nPoints += word == "v";
        if (word != "f")
        {
            continue;
        }
        while (words >> word)
        {
            const label i = std::atoi(word.c_str());
            if (i == 0 || i > nPoints || i < -nPoints)
            {
                OStringStream fault;
                fault
                    << "line " << lineNo << " has the corner " << word.c_str()
                    << " of " << nPoints << " before it";
                return fault.str();
            }
        }
    }
    return string::null;
}


void requireFinite
(
    const triSurface& surface,
    const dictionary& dict,
    const fileName& file
)
{
    forAll(surface, i)
    {
        for (const label pointi : surface[i])
        {
            const point& p = surface.points()[pointi];
            if (!std::isfinite(p.x() + p.y() + p.z()))
            {
                OStringStream allowed;
                allowed
                    << "corners of finite coordinates, triangle " << i
                    << " has the corner " << p;
                dictionaryInput::badValue(dict, "file", file, allowed.str());
            }
        }
    }
}

}


Foam::triSurface Foam::readWallSurface
(
    const dictionary& dict,
    const fileName& file
)
{
    const scalar scale =
        dictionaryInput::getPositiveOrDefault(dict, "scale", dimless, 1);

    const auto refuse = [&](const string& reason)
    {
        dictionaryInput::badValue
        (
            dict, "file", file,
            "a surface of triangles that can be read: " + reason
        );
    };

    string fault;
    if (file.hasExt("stl") || file.hasExt("STL"))
    {
        fault = faultOfSTL(file);
    }
    else if (file.hasExt("obj"))
    {
        fault = faultOfOBJ(file);
    }
    if (fault.size())
    {
        refuse(fault);
    }

    // What is not a number is looked for and reported by name
    const sigFpe::ignore ignoreFpe;

    triSurface surface;
    const string message
    (
        dictionaryInput::errorOf([&] { surface = triSurface(file); })
    );
    if (message.size())
    {
        refuse(message);
    }
    requireFinite(surface, dict, file);

    surface.scalePoints(scale);
    closeGaps(surface);
    return surface;
}
