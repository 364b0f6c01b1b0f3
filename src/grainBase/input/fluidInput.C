/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidInput.H"

#include "dictionaryInput.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "Time.H"

void Foam::checkTransportProperties
(
    const dictionary& dict,
    const wordList& others
)
{
    const word Newtonian("Newtonian");
    const word model(dict.getOrDefault<word>("transportModel", Newtonian));
    wordList allowed
    ({
        "FoamFile", "rho", "transportModel", model + "Coeffs", "HeleShaw",
        "scalars"
    });
    allowed.append(others);
    if (dict.found("mu") && others.found("mu"))
    {
        for (const word& name : {word("transportModel"), word("nu")})
        {
            if (dict.found(name))
            {
                dictionaryInput::badValue
                (
                    dict, name, dictionaryInput::written(dict, name),
                    "nothing, as there is mu"
                );
            }
        }
    }
    else if (model == Newtonian)
    {
        dictionaryInput::getPositive
        (
            dict.optionalSubDict(model + "Coeffs"), "nu", dimViscosity
        );
        allowed.append("nu");
    }
    dictionaryInput::checkKeywords(dict, allowed);
}


void Foam::checkPISO
(
    const dictionary& fvSolution,
    const wordList& others,
    const word& name
)
{
    const dictionary& dict = dictionaryInput::subDict(fvSolution, name);

    wordList allowed
    ({
        "nCorrectors", "nNonOrthogonalCorrectors", "momentumPredictor",
        "pRefCell", "pRefPoint", "pRefValue"
    });
    allowed.append(others);
    dictionaryInput::checkKeywords(dict, allowed);

    dictionaryInput::getLabelOrDefault(dict, "nCorrectors", 1, 1);
    dictionaryInput::getLabelOrDefault(dict, "nNonOrthogonalCorrectors", 0, 0);
}


void Foam::checkFluidInput
(
    const fvMesh& mesh,
    const dictionary& transportProperties,
    const wordList& others
)
{
    checkTransportProperties(transportProperties, others);
    checkPISO(mesh.solutionDict());
    refuseFiles(mesh.time(), {"MRFProperties"});
}


void Foam::refuseFiles(const Time& runTime, const wordList& files)
{
    for (const word& dir : {runTime.constant(), runTime.system()})
    {
        for (const word& name : files)
        {
            const fileName file(runTime.globalPath()/dir/name);
            if (isFile(file))
            {
                FatalErrorInFunction
                    << "What the file " << file << " asks for is not in this"
                    << " solver, which would pass over it" << nl
                    << "    allowed: a case without " << name
                    << exit(FatalError);
            }
        }
    }
}
