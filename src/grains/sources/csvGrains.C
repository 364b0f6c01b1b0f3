/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "csvGrains.H"

#include "csvTable.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "grainShapes.H"

addToSelection(grainSource, grainSources, csv)

template<int D>
Foam::grainSources::csv<D>::csv
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
    dict_(dict),
    file_(dictionaryInput::getAs<fileName>(dict, "file", "a table of grains")),
    material_
    (
        dict.found("material") ? ctx.materials.index(dict, "material") : -1
    )
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "file", "material", "temperature"}
    );

    if (!file_.isAbsolute())
    {
        file_ = ctx.space.mesh().time().globalPath()/file_;
    }
}


namespace
{

using namespace Foam;

//- By which the frame of a cluster's centres is turned
quaternion turn(const csvTable& table, const label i)
{
    if (!table.found("qw"))
    {
        return quaternion(quaternion::I);
    }
    const quaternion q
    (
        table.number("qw", i),
        vector
        (
            table.number("qx", i), table.number("qy", i), table.number("qz", i)
        )
    );
    if (mag(mag(q) - 1) > 1e-6)
    {
        table.badValue("qw,qx,qy,qz", i, "a quaternion of length 1");
    }
    return q;
}

}


template<int D>
nscd::Grains<D> Foam::grainSources::csv<D>::read() const
{
    const csvTable table
    (
        dict_,
        file_,
        {"x", "y", "z", "radius"},
        {
            "vx", "vy", "vz", "wx", "wy", "wz", "material", "temperature",
            "shape", "qw", "qx", "qy", "qz"
        }
    );
    const grainSpace<D>& space = this->context_.space;
    const grainMaterials& materials = this->context_.materials;

    const auto vectorOf = [&](const char* x, const char* y, const char* z, label i)
    {
        return vector
        (
            table.number(x, i), table.number(y, i), table.number(z, i)
        );
    };

    nscd::Vectors<D> centres;
    std::vector<double> radii;
    for (label i = 0; i < table.size(); ++i)
    {
        centres.push_back(space.fromSpace(vectorOf("x", "y", "z", i)));
        radii.push_back(table.number("radius", i));
        if (radii.back() < 1e-100)
        {
            table.badValue("radius", i, "a value > 0, at least 1e-100");
        }
    }

    const bool hasMaterials = table.found("material");
    if (!hasMaterials && material_ < 0)
    {
        dictionaryInput::missing
        (
            dict_, "material",
            "one of " + dictionaryInput::listed(materials.names())
          + ", or a column 'material' of " + file_
        );
    }

    // Lines may name others
    const label material = max(material_, 0);
    nscd::Grains<D> result(this->grains(centres, radii, material));
    for (label i = 0; i < table.size(); ++i)
    {
        const vector v(vectorOf("vx", "vy", "vz", i));
        const vector w(vectorOf("wx", "wy", "wz", i));
        if (!space.holds(v))
        {
            table.badValue("vx,vy,vz", i, "no velocity across the mesh");
        }
        if (!space.holdsSpin(w))
        {
            table.badValue("wx,wy,wz", i, "spin about the normal of the mesh");
        }
        result.velocity[i] = space.fromSpace(v);
        result.spin[i] = space.spinFromSpace(w);
        if (table.found("temperature"))
        {
            result.temperature[i] = table.number("temperature", i);
            if (result.temperature[i] < 0)
            {
                table.badValue("temperature", i, "a value > 0, or 0 for none");
            }
        }
        if (table.found("shape"))
        {
            const label shapei =
                this->context_.shapes.find(table.text("shape", i));
            if (shapei < -1)
            {
                table.badValue
                (
                    "shape", i,
                    dictionaryInput::listed(this->context_.shapes.names())
                );
            }
            result.shape[i] = shapei;
            result.mass[i] =
                materials.density(material)*space.volume(result, i);
        }
        result.orientation[i] =
            this->context_.shapes.ofAxes
            (
                result.shape[i], space.orientationFromSpace(turn(table, i))
            );

        if (hasMaterials)
        {
            const label m = materials.names().find(table.text("material", i));
            if (m < 0)
            {
                table.badValue
                (
                    "material", i, dictionaryInput::listed(materials.names())
                );
            }
            result.mass[i] *= materials.density(m)/materials.density(material);
            result.material[i] = m;
        }
    }
    return result;
}
