// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/problem/Fclib.hpp"

#include "nscd/base/Check.hpp"
#include "nscd/io/Hdf5.hpp"
#include "nscd/io/ReplaceFile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace nscd
{

namespace
{

const std::string local = "fclib_local/";

class Reader
{
public:
    explicit Reader(const std::string& file) : name_(file), in_(file, Hdf5File::Mode::read) {}

    template <class... Parts>
    [[noreturn]] void fail(const Parts&... parts) const
    {
        std::ostringstream message;
        message << name_ << ": ";
        (message << ... << parts);
        throw std::runtime_error(message.str());
    }

    bool contains(const std::string& set) const { return in_.contains(set); }

    /// A list, or a number, of at least 'size' entries.
    template <class T>
    std::vector<T> list(const std::string& set, std::size_t size) const
    {
        if (!in_.contains(set))
        {
            fail("there is no ", set);
        }
        std::vector<T> values = in_.read<T>(set).values;
        if (values.size() < size)
        {
            fail(set, " has ", values.size(), " instead of ", size, " entries");
        }
        return values;
    }

    std::int64_t number(const std::string& set) const { return list<std::int64_t>(set, 1)[0]; }

    /// Numbers that are finite, exactly 'size' of them.
    std::vector<double> numbers(const std::string& set, std::size_t size) const
    {
        const std::vector<double> values = list<double>(set, size);
        if (values.size() != size)
        {
            fail(set, " has ", values.size(), " instead of ", size, " entries");
        }
        checkFinite(set, values, size);
        return values;
    }

    void checkFinite(const std::string& set, const std::vector<double>& values, std::size_t size) const
    {
        const auto end = values.begin() + size;
        const auto bad = std::find_if(values.begin(), end, [](double value) { return !std::isfinite(value); });
        if (bad != end)
        {
            fail(set, ": entry ", bad - values.begin(), " is not finite");
        }
    }

    template <int D>
    Vectors<D> vectors(const std::string& set, std::size_t contacts) const
    {
        const std::vector<double> values = numbers(set, D * contacts);
        Vectors<D> result(contacts);
        for (std::size_t c = 0; c < contacts; ++c)
        {
            result[c] = Eigen::Map<const Vector<D>>(values.data() + D * c);
        }
        return result;
    }

private:
    std::string name_;
    Hdf5File in_;
};

/// W in one of the three forms.
class MatrixReader
{
public:
    MatrixReader(const Reader& in, std::string group) : in_(in), group_(std::move(group))
    {
        rows_ = in_.number(group_ + "m");
        const std::int64_t columns = in_.number(group_ + "n");
        if (rows_ < 0 || rows_ > std::numeric_limits<std::int32_t>::max() || rows_ != columns)
        {
            in_.fail(group_, "m and n: W of ", rows_, " x ", columns, " is not square");
        }
    }

    std::size_t size() const { return static_cast<std::size_t>(rows_); }

    template <class Entry>
    std::vector<Entry> entries() const
    {
        std::vector<Entry> entries;
        const std::int64_t form = in_.number(group_ + "nz");
        if (form >= 0)
        {
            const auto count = static_cast<std::size_t>(form);
            const auto i = indices("i", count), p = indices("p", count);
            const auto x = values(count);
            for (std::size_t k = 0; k < count; ++k)
            {
                entries.push_back({i[k], p[k], x[k]});
            }
        }
        else if (form == -1 || form == -2)
        {
            const std::vector<std::size_t> begin = lines();
            const auto i = indices("i", begin.back());
            const auto x = values(begin.back());
            for (std::size_t line = 0; line < size(); ++line)
            {
                for (std::size_t k = begin[line]; k < begin[line + 1]; ++k)
                {
                    const int here = static_cast<int>(line);
                    entries.push_back(form == -1 ? Entry{i[k], here, x[k]} : Entry{here, i[k], x[k]});
                }
            }
        }
        else
        {
            in_.fail(group_, "nz is ", form, ": -2, -1 or the number of triplets is possible");
        }
        return entries;
    }

private:
    std::vector<double> values(std::size_t count) const
    {
        const std::string set = group_ + "x";
        const std::vector<double> x = in_.list<double>(set, count);
        in_.checkFinite(set, x, count);
        return x;
    }

    /// Row or column numbers.
    std::vector<int> indices(const std::string& set, std::size_t count) const
    {
        const std::vector<std::int64_t> found = in_.list<std::int64_t>(group_ + set, count);
        for (std::size_t k = 0; k < count; ++k)
        {
            if (found[k] < 0 || found[k] >= rows_)
            {
                in_.fail(group_, set, ": entry ", k, " is ", found[k], ", outside 0 ... ", rows_ - 1);
            }
        }
        return {found.begin(), found.begin() + count};
    }

    /// Where the rows or columns begin, and the end of the last.
    std::vector<std::size_t> lines() const
    {
        const std::vector<std::int64_t> p = in_.list<std::int64_t>(group_ + "p", size() + 1);
        for (std::size_t k = 0; k <= size(); ++k)
        {
            if (p[k] < (k > 0 ? p[k - 1] : 0))
            {
                in_.fail(group_, "p: entry ", k, " is ", p[k], ", less than the one before or than 0");
            }
        }
        return {p.begin(), p.begin() + size() + 1};
    }

    const Reader& in_;
    std::string group_;
    std::int64_t rows_;
};

template <int D>
FclibProblem<D> readProblem(const Reader& in)
{
    const MatrixReader matrix(in, local + "W/");
    if (matrix.size() % D != 0)
    {
        in.fail(local, "W/m is ", matrix.size(), ", not a multiple of the dimension ", D);
    }
    const std::size_t contacts = matrix.size() / D;
    const auto read = [&](const std::string& group) -> FclibSolution<D> {
        return {in.vectors<D>(group + "/r", contacts), in.vectors<D>(group + "/u", contacts)};
    };

    Vectors<D> q = in.vectors<D>(local + "vectors/q", contacts);
    std::vector<double> friction = in.numbers(local + "vectors/mu", contacts);
    const auto entries = matrix.entries<typename SparseProblem<D>::Entry>();
    FclibProblem<D> result = [&]() -> FclibProblem<D>
    {
        try
        {
            return {{std::move(q), std::move(friction), entries}, {}, {}};
        }
        catch (const std::invalid_argument& error)
        {
            in.fail("fclib_local: ", error.what());
        }
    }();
    if (in.contains("guesses"))
    {
        const std::int64_t guesses = in.number("guesses/number_of_guesses");
        for (std::int64_t k = 1; k <= guesses; ++k)
        {
            result.guesses.push_back(read("guesses/" + std::to_string(k)));
        }
    }
    if (in.contains("solution"))
    {
        result.solution = read("solution");
    }
    return result;
}

void writeIntegers(Hdf5File& out, const std::string& set, const std::vector<std::int32_t>& values)
{
    out.write(set, Table<std::int32_t>{values.size(), 1, values}, "1");
}

template <int D>
void writeVectors(Hdf5File& out, const std::string& set, const Vectors<D>& vectors, const std::string& units)
{
    Table<double> table{D * vectors.size(), 1, {}};
    for (const Vector<D>& v : vectors)
    {
        table.values.insert(table.values.end(), v.data(), v.data() + D);
    }
    out.write(set, table, units);
}

template <int D>
void writeSolution(Hdf5File& out, const std::string& group, const FclibSolution<D>& s)
{
    writeVectors<D>(out, group + "/r", s.r, "N s");
    writeVectors<D>(out, group + "/u", s.u, "m/s");
}

/// The entries of W that are not zero, row after row.
template <int D>
std::vector<typename SparseProblem<D>::Entry> entriesOf(const SparseProblem<D>& problem)
{
    std::vector<typename SparseProblem<D>::Entry> entries;
    for (int c = 0; c < problem.contacts(); ++c)
    {
        for (int i = 0; i < D; ++i)
        {
            for (const auto* n = problem.begin(c); n != problem.end(c); ++n)
            {
                for (int j = 0; j < D; ++j)
                {
                    if (n->W(i, j) != 0)
                    {
                        entries.push_back({D * c + i, D * n->contact + j, n->W(i, j)});
                    }
                }
            }
        }
    }
    return entries;
}

template <int D>
void writeMatrix(Hdf5File& out, const std::string& group, const SparseProblem<D>& problem, FclibStorage storage)
{
    using Entry = typename SparseProblem<D>::Entry;
    std::vector<Entry> entries = entriesOf(problem);
    if (entries.size() > std::numeric_limits<std::int32_t>::max())
    {
        refuse("W has ", entries.size(), " entries, too many for FCLIB");
    }
    if (storage == FclibStorage::columns)
    {
        std::stable_sort(entries.begin(), entries.end(),
                         [](const Entry& a, const Entry& b) { return a.column < b.column; });
    }
    const std::int32_t size = D * problem.contacts();
    const auto count = static_cast<std::int32_t>(entries.size());
    std::vector<std::int32_t> p, i;
    Table<double> x{entries.size(), 1, {}};
    for (const Entry& e : entries)
    {
        x.values.push_back(e.value);
        i.push_back(storage == FclibStorage::rows ? e.column : e.row);
        p.push_back(storage == FclibStorage::rows ? e.row : e.column);
    }
    if (storage != FclibStorage::triplets)
    {
        std::vector<std::int32_t> begin(size + 1, 0);
        for (const std::int32_t line : p)
        {
            ++begin[line + 1];
        }
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        p = begin;
    }
    writeIntegers(out, group + "m", {size});
    writeIntegers(out, group + "n", {size});
    writeIntegers(out, group + "nzmax", {count});
    writeIntegers(out, group + "nz",
                  {storage == FclibStorage::triplets  ? count
                   : storage == FclibStorage::columns ? -1
                                                      : -2});
    writeIntegers(out, group + "p", p);
    writeIntegers(out, group + "i", i);
    out.write(group + "x", x, "1/kg");
}

/// Let 'write' make a temporary file and give it its name when it is complete.
template <class Write>
void writeWhole(const std::string& file, Write write)
{
    const std::string temporary = file + ".part";
    try
    {
        write(temporary);
        replaceFile(temporary, file);
    }
    catch (...)
    {
        std::remove(temporary.c_str());
        throw;
    }
}

}  // namespace

std::variant<FclibProblem<2>, FclibProblem<3>> readFclib(const std::string& file)
{
    const Reader in(file);
    if (!in.contains("fclib_local"))
    {
        in.fail("there is no fclib_local", in.contains("fclib_global") ? ", and fclib_global is not supported" : "");
    }
    if (in.contains(local + "V") || in.contains(local + "R"))
    {
        in.fail(local, "V and R: equality constraints are not supported");
    }
    const std::int64_t dimension = in.number(local + "spacedim");
    if (dimension == 2)
    {
        return readProblem<2>(in);
    }
    if (dimension != 3)
    {
        in.fail(local, "spacedim is ", dimension, " instead of 2 or 3");
    }
    return readProblem<3>(in);
}

template <int D>
void writeFclib(const std::string& file, const FclibProblem<D>& p, FclibStorage storage)
{
    writeWhole(file,
               [&](const std::string& temporary)
               {
                   Hdf5File out(temporary, Hdf5File::Mode::create);
                   writeIntegers(out, local + "spacedim", {D});
                   writeMatrix<D>(out, local + "W/", p.problem, storage);
                   writeVectors<D>(out, local + "vectors/q", p.problem.q(), "m/s");
                   const std::vector<double>& friction = p.problem.friction();
                   out.write(local + "vectors/mu", Table<double>{friction.size(), 1, friction}, "1");
                   if (!p.guesses.empty())
                   {
                       const auto guesses = static_cast<std::int32_t>(p.guesses.size());
                       writeIntegers(out, "guesses/number_of_guesses", {guesses});
                       for (std::int32_t k = 0; k < guesses; ++k)
                       {
                           writeSolution<D>(out, "guesses/" + std::to_string(k + 1), p.guesses[k]);
                       }
                   }
                   if (p.solution)
                   {
                       writeSolution<D>(out, "solution", *p.solution);
                   }
                   out.close();
               });
}

template <int D>
void writeFclibSolution(const std::string& source, const std::string& target, const FclibSolution<D>& solution)
{
    namespace fs = std::filesystem;
    // Through a symbolic link, not in its place
    writeWhole(fs::weakly_canonical(target).string(),
               [&](const std::string& temporary)
               {
                   fs::copy_file(source, temporary, fs::copy_options::overwrite_existing);
                   Hdf5File out(temporary, Hdf5File::Mode::modify);
                   if (out.contains("solution"))
                   {
                       out.remove("solution");
                   }
                   writeSolution<D>(out, "solution", solution);
                   out.close();
               });
}

template void writeFclib<2>(const std::string&, const FclibProblem<2>&, FclibStorage);
template void writeFclib<3>(const std::string&, const FclibProblem<3>&, FclibStorage);
template void writeFclibSolution<2>(const std::string&, const std::string&, const FclibSolution<2>&);
template void writeFclibSolution<3>(const std::string&, const std::string&, const FclibSolution<3>&);

}  // namespace nscd
