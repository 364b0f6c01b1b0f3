/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "csvTable.H"

#include "dictionaryInput.H"
#include "sigFpe.H"

#include <cstdlib>
#include <fstream>

namespace
{

std::string trimmed(const std::string& s)
{
    const auto first = s.find_first_not_of(" \t\r\"");
    const auto last = s.find_last_not_of(" \t\r\"");
    return
        first == std::string::npos
      ? std::string()
      : s.substr(first, last - first + 1);
}

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> parts;
    std::size_t begin = 0;
    while (true)
    {
        const std::size_t comma = line.find(',', begin);
        parts.push_back(trimmed(line.substr(begin, comma - begin)));
        if (comma == std::string::npos)
        {
            return parts;
        }
        begin = comma + 1;
    }
}

}


Foam::csvTable::csvTable
(
    const dictionary& dict,
    const fileName& file,
    const wordList& required,
    const wordList& optional
)
:
    dict_(dict),
    file_(file)
{
    std::ifstream is(file);
    std::string text;
    label line = 0;
    bool header = true;

    while (std::getline(is, text))
    {
        ++line;
        if (line == 1 && text.compare(0, 3, "\xef\xbb\xbf") == 0)
        {
            // Byte order mark of spreadsheets
            text.erase(0, 3);
        }
        const std::string content = trimmed(text);
        if (content.empty() || content[0] == '#')
        {
            continue;
        }
        std::vector<std::string> parts = split(text);
        if (header)
        {
            readHeader(parts, required, optional);
            header = false;
            continue;
        }
        if (parts.size() != column_.size())
        {
            FatalIOErrorInFunction(dict_)
                << "Keyword 'file': line " << line << " of " << file_
                << " has " << label(parts.size()) << " columns" << nl
                << "    allowed: " << label(column_.size())
                << ", as in the header" << exit(FatalIOError);
        }
        rows_.push_back(std::move(parts));
        line_.push_back(line);
    }

    if (header)
    {
        dictionaryInput::badValue
        (
            dict_, "file", file_,
            "a readable file with a header line of the columns "
          + dictionaryInput::listed(required)
        );
    }
}


void Foam::csvTable::readHeader
(
    const std::vector<std::string>& names,
    const wordList& required,
    const wordList& optional
)
{
    for (const std::string& name : names)
    {
        const word column(name);
        if (!required.found(column) && !optional.found(column))
        {
            FatalIOErrorInFunction(dict_)
                << "Keyword 'file': unknown column '" << name.c_str()
                << "' in the header of " << file_ << nl
                << "    allowed: " << flatOutput(required)
                << " and, optional, " << flatOutput(optional)
                << exit(FatalIOError);
        }
        const label i = label(column_.size());
        if (!column_.emplace(name, i).second)
        {
            FatalIOErrorInFunction(dict_)
                << "Keyword 'file': column '" << name.c_str()
                << "' stands twice in the header of " << file_ << nl
                << "    allowed: each column once" << exit(FatalIOError);
        }
    }
    for (const word& column : required)
    {
        if (!found(column))
        {
            FatalIOErrorInFunction(dict_)
                << "Keyword 'file': column '" << column
                << "' is missing in the header of " << file_ << nl
                << "    allowed: " << flatOutput(required)
                << " and, optional, " << flatOutput(optional)
                << exit(FatalIOError);
        }
    }
}


const std::string& Foam::csvTable::text
(
    const std::string& column,
    const label row
) const
{
    return rows_[row][column_.at(column)];
}


Foam::scalar Foam::csvTable::number
(
    const std::string& column,
    const label row
) const
{
    if (!found(column))
    {
        return 0;
    }
    const std::string& s = text(column, row);
    char* end = nullptr;

    // A number too large for a double would trap
    const sigFpe::ignore ignoreFpe;
    const scalar value = std::strtod(s.c_str(), &end);

    if (s.empty() || *end || !(mag(value) <= GREAT))
    {
        badValue(column, row, "a finite number of at most 1e15");
    }
    return value;
}


void Foam::csvTable::badValue
(
    const std::string& column,
    const label row,
    const std::string& allowed
) const
{
    const std::string value = found(column) ? text(column, row) : "";

    FatalIOErrorInFunction(dict_)
        << "Keyword 'file': line " << line_[row] << " of " << file_
        << ", column '" << column.c_str() << "' has the value '"
        << value.c_str() << "'" << nl
        << "    allowed: " << allowed.c_str() << exit(FatalIOError);
}
