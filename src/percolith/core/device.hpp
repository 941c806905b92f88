// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function that is callable from host and GPU code alike. The only macro of the project.
#if defined(__CUDACC__)
#define PERCOLITH_DEVICE __host__ __device__ __forceinline__
#elif defined(__SANITIZE_ADDRESS__)
// With the checks of the sanitizers inside, whole kernels as one function take g++ minutes.
#define PERCOLITH_DEVICE inline
#else
#define PERCOLITH_DEVICE [[gnu::always_inline]] inline
#endif
