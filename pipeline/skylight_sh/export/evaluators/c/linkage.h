#pragma once
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_EXTERN
#define SKYLIGHT_SH_API static inline
#else
#define SKYLIGHT_SH_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_API extern "C"
#else
#define SKYLIGHT_SH_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif
