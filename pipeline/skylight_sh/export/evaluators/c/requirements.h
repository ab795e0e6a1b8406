#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_IMPLEMENTATION) && !defined(SKYLIGHT_SH_EXTERN)
#error "Define SKYLIGHT_SH_EXTERN in every unit, SKYLIGHT_SH_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_API) && defined(SKYLIGHT_SH_EXTERN) && !defined(SKYLIGHT_SH_DECLARED)
#error "Define SKYLIGHT_SH_EXTERN before this file is included for the first time."
#endif
#if defined(SKYLIGHT_SH_DECLARED) && !defined(SKYLIGHT_SH_EXTERN)
#error "Leave SKYLIGHT_SH_EXTERN defined: this file was included with it before."
#endif
