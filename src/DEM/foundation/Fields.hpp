// SPDX-License-Identifier: GPL-3.0-or-later
//
// A struct as numbers: for other ranks and for restart. It lists its members once,
//
//     template<class S, class F> static void fields(S& s, F& f) { f(s.a); f(s.b); }
//
// and packing, unpacking and the count of numbers follow from that. Numbers, bool, arrays,
// vectors in space, structs with such a list, and std::vector of all these (with its length).
// Integers are exact below 2^53.
// Proof: tests/unit/DEM/fields.cpp
#pragma once

#include "particles/vector.hpp"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace dem
{

template<class T> struct isStdVector : std::false_type {};
template<class T> struct isStdVector<std::vector<T>> : std::true_type {};


//- Appends what it is given to a list of numbers
class Packer
{
public:

    explicit Packer(std::vector<double>& to) : to_(to) {}

    template<class T>
    void operator()(const T& value)
    {
        if constexpr (std::is_arithmetic_v<T>) to_.push_back(double(value));
        else if constexpr (std::is_array_v<T>) for (const auto& v : value) (*this)(v);
        else if constexpr (std::is_same_v<T, Vec3>)
        {
            to_.insert(to_.end(), value.data(), value.data() + 3);
        }
        else if constexpr (isStdVector<T>::value)
        {
            (*this)(value.size());
            for (const auto& v : value) (*this)(v);
        }
        else T::fields(value, *this);
    }

private:

    std::vector<double>& to_;
};


//- Takes from a list of numbers what a Packer has put there
class Unpacker
{
public:

    explicit Unpacker(const double* from) : from_(from) {}

    const double* at() const { return from_; }

    template<class T>
    void operator()(T& value)
    {
        if constexpr (std::is_same_v<T, bool>) value = *from_++ > 0;
        else if constexpr (std::is_arithmetic_v<T>) value = T(*from_++);
        else if constexpr (std::is_array_v<T>) for (auto& v : value) (*this)(v);
        else if constexpr (std::is_same_v<T, Vec3>)
        {
            value = Vec3(from_[0], from_[1], from_[2]);
            from_ += 3;
        }
        else if constexpr (isStdVector<T>::value)
        {
            value.resize(std::size_t(*from_++));
            for (auto& v : value) (*this)(v);
        }
        else T::fields(value, *this);
    }

private:

    const double* from_;
};


template<class T>
void pack(const T& value, std::vector<double>& to)
{
    Packer packer(to);
    packer(value);
}

template<class T>
T unpack(const double*& from)
{
    T value{};
    Unpacker unpacker(from);
    unpacker(value);
    from = unpacker.at();
    return value;
}

//- All of them, from what one rank has sent
template<class T>
std::vector<T> unpackAll(const std::vector<double>& from)
{
    std::vector<T> result;
    for (const double* p = from.data(); p < from.data() + from.size();)
    {
        result.push_back(unpack<T>(p));
    }
    return result;
}

//- Of a struct without lists
template<class T>
std::size_t fieldCount()
{
    std::vector<double> numbers;
    pack(T{}, numbers);
    return numbers.size();
}

}
