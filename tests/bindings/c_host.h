/* A host in C, as c_host.c has it, for the C++ program that runs the tests. */
#ifndef C_HOST_H
#define C_HOST_H

#ifdef __cplusplus
extern "C" {
#endif

/* Runs a drop of fluid through the whole interface. Returns NULL, or what was not as it should
 * be. */
const char* run_c_host(void);

#ifdef __cplusplus
}
#endif

#endif
