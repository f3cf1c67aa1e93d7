// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Types.h"

namespace TemporalCoherence
{

namespace
{

bool FindInteger(std::size_t bytes, bool isSigned, ScalarType& type)
{
  switch (bytes)
  {
    case 1:
      type = isSigned ? ScalarType::Int8 : ScalarType::UInt8;
      return true;
    case 2:
      type = isSigned ? ScalarType::Int16 : ScalarType::UInt16;
      return true;
    case 4:
      type = isSigned ? ScalarType::Int32 : ScalarType::UInt32;
      return true;
    case 8:
      type = isSigned ? ScalarType::Int64 : ScalarType::UInt64;
      return true;
    default:
      return false;
  }
}

}

bool FindScalarType(hid_t type, ScalarType& scalarType)
{
  const std::size_t bytes = H5Tget_size(type);
  switch (H5Tget_class(type))
  {
    case H5T_INTEGER:
      return FindInteger(bytes, H5Tget_sign(type) != H5T_SGN_NONE, scalarType);
    case H5T_FLOAT:
      scalarType = bytes <= 4 ? ScalarType::Float32 : ScalarType::Float64;
      return bytes == 2 || bytes == 4 || bytes == 8; // HDF5 converts half precision
    default:
      return false;
  }
}

hid_t MemoryTypeOf(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return H5T_NATIVE_INT8;
    case ScalarType::UInt8:
      return H5T_NATIVE_UINT8;
    case ScalarType::Int16:
      return H5T_NATIVE_INT16;
    case ScalarType::UInt16:
      return H5T_NATIVE_UINT16;
    case ScalarType::Int32:
      return H5T_NATIVE_INT32;
    case ScalarType::UInt32:
      return H5T_NATIVE_UINT32;
    case ScalarType::Int64:
      return H5T_NATIVE_INT64;
    case ScalarType::UInt64:
      return H5T_NATIVE_UINT64;
    case ScalarType::Float32:
      return H5T_NATIVE_FLOAT;
    case ScalarType::Float64:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

}
