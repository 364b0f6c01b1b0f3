// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/io/Hdf5.hpp"

#include <fstream>
#include <stdexcept>

namespace nscd
{

namespace
{

/// Files are closed here.  One that could not be written, as on a full disc, is still open to HDF5, whose own attempt
/// to close it when the program ends would crash.
const herr_t closesNothingAtExit = H5dont_atexit();

/// Programs of OpenFOAM look for its header in each file of a time directory, and warn of each that has none.
const char headerText[] = "FoamFile { version 2.0; format binary; class hdf5; object state; }\n";
constexpr hsize_t headerSize = 512;   // the least that HDF5 knows

template <class T>
hid_t nativeType();

template <>
hid_t nativeType<double>()
{
    return H5T_NATIVE_DOUBLE;
}

template <>
hid_t nativeType<std::int32_t>()
{
    return H5T_NATIVE_INT32;
}

template <>
hid_t nativeType<std::int64_t>()
{
    return H5T_NATIVE_INT64;
}

hid_t openFile(const std::string& name, Hdf5File::Mode mode)
{
    switch (mode)
    {
    case Hdf5File::Mode::read:
        return H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    case Hdf5File::Mode::modify:
        return H5Fopen(name.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    default:
        const Hdf5Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
        H5Pset_userblock(properties, headerSize);
        return H5Fcreate(name.c_str(), H5F_ACC_TRUNC, properties, H5P_DEFAULT);
    }
}

/// In front of what HDF5 has of the file.
void writeHeader(const std::string& name)
{
    std::string header(headerText);
    header.resize(headerSize, '\n');
    std::fstream file(name, std::ios::in | std::ios::out | std::ios::binary);
    file.write(header.data(), static_cast<std::streamsize>(header.size()));
    file.close();
    if (!file)
    {
        throw std::runtime_error(name + ": cannot be written");
    }
}

/// What HDF5 says about the last failure, innermost first.
std::string reason()
{
    std::string text;
    const auto collect = [](unsigned, const H5E_error2_t* error, void* data) -> herr_t
    {
        std::string& collected = *static_cast<std::string*>(data);
        if (error->desc && collected.empty())
        {
            collected = error->desc;
        }
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &text);
    return text;
}

Hdf5Handle textType(std::size_t length)
{
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, length > 0 ? length : 1);
    return type;
}

}  // namespace

bool Hdf5Handle::close()
{
    const bool closed = id_ < 0 || close_(id_) >= 0;
    id_ = -1;
    return closed;
}

Hdf5File::Quiet::Quiet()
{
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5File::Quiet::~Quiet()
{
    H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

Hdf5File::Hdf5File(const std::string& name, Mode mode)
    : name_(name), isNew_(mode == Mode::create), file_(openFile(name, mode), H5Fclose)
{
    check(file_, mode == Mode::create ? "cannot be created" : "cannot be opened");
}

hid_t Hdf5File::check(hid_t result, const std::string& action) const
{
    if (result < 0)
    {
        throw std::runtime_error(name_ + ": " + action + ": " + reason());
    }
    return result;
}

void Hdf5File::close()
{
    check(H5Fflush(file_, H5F_SCOPE_LOCAL), "cannot be written");
    check(file_.close() ? 0 : -1, "cannot be closed");
    if (isNew_)
    {
        writeHeader(name_);
    }
}

template <class T>
void Hdf5File::write(const std::string& name, const Table<T>& table, const std::string& units)
{
    const std::string action = "cannot write " + name;
    const hsize_t extent[2] = {table.rows, table.columns};
    const Hdf5Handle space(check(H5Screate_simple(table.columns == 1 ? 1 : 2, extent, nullptr), action), H5Sclose);
    const Hdf5Handle links(check(H5Pcreate(H5P_LINK_CREATE), action), H5Pclose);
    H5Pset_create_intermediate_group(links, 1);
    const Hdf5Handle set(
        check(H5Dcreate2(file_, name.c_str(), nativeType<T>(), space, links, H5P_DEFAULT, H5P_DEFAULT), action),
        H5Dclose);
    if (table.rows > 0)
    {
        check(H5Dwrite(set, nativeType<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()), action);
    }
    const Hdf5Handle type = textType(units.size());
    const Hdf5Handle scalar(check(H5Screate(H5S_SCALAR), action), H5Sclose);
    const Hdf5Handle attribute(check(H5Acreate2(set, "units", type, scalar, H5P_DEFAULT, H5P_DEFAULT), action),
                               H5Aclose);
    check(H5Awrite(attribute, type, units.c_str()), action);
}

template <class T>
Table<T> Hdf5File::read(const std::string& name) const
{
    const std::string action = "cannot read " + name;
    const Hdf5Handle set(check(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), action), H5Dclose);
    const Hdf5Handle space(check(H5Dget_space(set), action), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || rank > 2)
    {
        throw std::runtime_error(name_ + ": " + action + ": it has " + std::to_string(rank) + " dimensions");
    }
    hsize_t extent[2] = {1, 1};
    check(H5Sget_simple_extent_dims(space, extent, nullptr), action);
    Table<T> table{extent[0], extent[1], std::vector<T>(extent[0] * extent[1])};
    if (!table.values.empty())
    {
        check(H5Dread(set, nativeType<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()), action);
    }
    return table;
}

bool Hdf5File::contains(const std::string& name) const
{
    for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1))
    {
        if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        {
            return false;
        }
    }
    return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5File::remove(const std::string& name)
{
    check(H5Ldelete(file_, name.c_str(), H5P_DEFAULT), "cannot remove " + name);
}

void Hdf5File::writeAttribute(const std::string& name, double value)
{
    const std::string action = "cannot write attribute " + name;
    const Hdf5Handle scalar(check(H5Screate(H5S_SCALAR), action), H5Sclose);
    const Hdf5Handle attribute(
        check(H5Acreate2(file_, name.c_str(), H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT), action), H5Aclose);
    check(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), action);
}

void Hdf5File::writeAttribute(const std::string& name, const std::string& text)
{
    const std::string action = "cannot write attribute " + name;
    const Hdf5Handle type = textType(text.size());
    const Hdf5Handle scalar(check(H5Screate(H5S_SCALAR), action), H5Sclose);
    const Hdf5Handle attribute(
        check(H5Acreate2(file_, name.c_str(), type, scalar, H5P_DEFAULT, H5P_DEFAULT), action), H5Aclose);
    check(H5Awrite(attribute, type, text.c_str()), action);
}

bool Hdf5File::hasAttribute(const std::string& name) const
{
    return H5Aexists(file_, name.c_str()) > 0;
}

double Hdf5File::readNumber(const std::string& name) const
{
    const std::string action = "cannot read attribute " + name;
    const Hdf5Handle attribute(check(H5Aopen(file_, name.c_str(), H5P_DEFAULT), action), H5Aclose);
    double value = 0;
    check(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), action);
    return value;
}

std::string Hdf5File::readText(const std::string& name) const
{
    const std::string action = "cannot read attribute " + name;
    const Hdf5Handle attribute(check(H5Aopen(file_, name.c_str(), H5P_DEFAULT), action), H5Aclose);
    const Hdf5Handle stored(check(H5Aget_type(attribute), action), H5Tclose);
    if (H5Tget_class(stored) != H5T_STRING || H5Tis_variable_str(stored) > 0)
    {
        throw std::runtime_error(name_ + ": " + action + ": it is not a text of fixed length");
    }
    std::string text(H5Tget_size(stored), '\0');
    const Hdf5Handle type = textType(text.size());
    check(H5Aread(attribute, type, text.data()), action);
    return text.c_str();
}

template void Hdf5File::write(const std::string&, const Table<double>&, const std::string&);
template void Hdf5File::write(const std::string&, const Table<std::int32_t>&, const std::string&);
template void Hdf5File::write(const std::string&, const Table<std::int64_t>&, const std::string&);
template Table<double> Hdf5File::read(const std::string&) const;
template Table<std::int32_t> Hdf5File::read(const std::string&) const;
template Table<std::int64_t> Hdf5File::read(const std::string&) const;

}  // namespace nscd
