/* Stands in for libcuda.so: device memory is the host's, and nothing is asynchronous. The PTX of a module is
   kept in STUB_DIR; when a kernel is launched for the first time ptx2c.py translates it to C, which is
   compiled and then run, thread after thread.

   It has the functions that Dr.Jit looks up. Those that kernels need are here; the others end the program. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SUCCESS = 0, OUT_OF_MEMORY = 2, UNKNOWN = 999 };

typedef struct {
    char path[4096];
} Module;

typedef struct {
    const Module *module;
    char name[256];
    void (*launch)(void **parameters, uint32_t blocks, uint32_t threads);
} Function;

// --- The device: one, of some compute capability, with the driver of CUDA 12.4 -----------------------------

int cuInit(unsigned flags) { return SUCCESS; }

int cuDriverGetVersion(int *version) {
    *version = 12040;
    return SUCCESS;
}

int cuDeviceGetCount(int *count) {
    *count = 1;
    return SUCCESS;
}

int cuDeviceGet(int *device, int ordinal) {
    *device = ordinal;
    return SUCCESS;
}

int cuDeviceGetName(char *name, int size, int device) {
    snprintf(name, size, "stub");
    return SUCCESS;
}

int cuDeviceTotalMem_v2(size_t *bytes, int device) {
    *bytes = (size_t)8 << 30;
    return SUCCESS;
}

int cuDeviceGetAttribute(int *value, int attribute, int device) {
    const char *given = getenv("STUB_CAPABILITY");
    const int capability = given ? atoi(given) : 90;
    switch (attribute) {
    case 16: // multiprocessors
        *value = 132;
        break;
    case 41: // unified addresses
        *value = 1;
        break;
    case 75:
        *value = capability / 10;
        break;
    case 76:
        *value = capability % 10;
        break;
    case 97: // bytes of shared memory for a block
        *value = 232448;
        break;
    default:
        *value = 0;
    }
    return SUCCESS;
}

int cuDeviceCanAccessPeer(int *can, int device, int peer) {
    *can = 0;
    return SUCCESS;
}

int cuDevicePrimaryCtxRetain(void **context, int device) {
    static int primary;
    *context = &primary;
    return SUCCESS;
}

int cuDevicePrimaryCtxRelease_v2(int device) { return SUCCESS; }
int cuCtxEnablePeerAccess(void *context, unsigned flags) { return SUCCESS; }
int cuCtxPushCurrent_v2(void *context) { return SUCCESS; }
int cuCtxPopCurrent_v2(void **context) { return SUCCESS; }
int cuCtxSynchronize(void) { return SUCCESS; }

int cuGetErrorName(int error, const char **name) {
    *name = "STUB_ERROR";
    return SUCCESS;
}

int cuGetErrorString(int error, const char **text) {
    *text = "an error of the emulator, which has said more";
    return SUCCESS;
}

// --- Memory -----------------------------------------------------------------------------------------------

int cuMemAlloc_v2(void **memory, size_t bytes) {
    // Vectors of four numbers are aligned.
    if (posix_memalign(memory, 256, bytes) != 0)
        return OUT_OF_MEMORY;
    // Numbers that nobody has written are NaN.
    memset(*memory, 0xff, bytes);
    return SUCCESS;
}

int cuMemAllocHost_v2(void **memory, size_t bytes) { return cuMemAlloc_v2(memory, bytes); }

int cuMemFree_v2(void *memory) {
    free(memory);
    return SUCCESS;
}

int cuMemFreeHost(void *memory) { return cuMemFree_v2(memory); }
int cuMemAdvise(void *memory, size_t bytes, int advice, int device) { return SUCCESS; }

int cuMemcpy(void *to, const void *from, size_t bytes) {
    memmove(to, from, bytes);
    return SUCCESS;
}

int cuMemcpyAsync(void *to, const void *from, size_t bytes, void *stream) {
    return cuMemcpy(to, from, bytes);
}

int cuMemsetD8Async(uint8_t *memory, uint8_t value, size_t count, void *stream) {
    memset(memory, value, count);
    return SUCCESS;
}

int cuMemsetD16Async(uint16_t *memory, uint16_t value, size_t count, void *stream) {
    for (size_t i = 0; i < count; ++i)
        memory[i] = value;
    return SUCCESS;
}

int cuMemsetD32Async(uint32_t *memory, uint32_t value, size_t count, void *stream) {
    for (size_t i = 0; i < count; ++i)
        memory[i] = value;
    return SUCCESS;
}

int cuPointerGetAttribute(int *value, int attribute, void *memory) {
    *value = 2; // of the device
    return SUCCESS;
}

// --- Streams and events -----------------------------------------------------------------------------------

int cuStreamCreate(void **stream, unsigned flags) {
    static int only;
    *stream = &only;
    return SUCCESS;
}

int cuStreamDestroy_v2(void *stream) { return SUCCESS; }
int cuStreamSynchronize(void *stream) { return SUCCESS; }
int cuStreamWaitEvent(void *stream, void *event, unsigned flags) { return SUCCESS; }
int cuStreamWaitEvent_ptsz(void *stream, void *event, unsigned flags) { return SUCCESS; }

int cuLaunchHostFunc(void *stream, void (*function)(void *), void *data) {
    function(data);
    return SUCCESS;
}

int cuEventCreate(struct timespec **event, unsigned flags) {
    *event = calloc(1, sizeof(struct timespec));
    return SUCCESS;
}

int cuEventDestroy_v2(struct timespec *event) {
    free(event);
    return SUCCESS;
}

int cuEventRecord(struct timespec *event, void *stream) {
    clock_gettime(CLOCK_MONOTONIC, event);
    return SUCCESS;
}

int cuEventQuery(void *event) { return SUCCESS; }
int cuEventSynchronize(void *event) { return SUCCESS; }

int cuEventElapsedTime(float *milliseconds, const struct timespec *from, const struct timespec *to) {
    *milliseconds = (to->tv_sec - from->tv_sec) * 1e3f + (to->tv_nsec - from->tv_nsec) * 1e-6f;
    return SUCCESS;
}

// --- Kernels ----------------------------------------------------------------------------------------------

int cuModuleLoadData(Module **module, const char *ptx) {
    static int count;
    *module = calloc(1, sizeof(Module));
    snprintf((*module)->path, sizeof((*module)->path), "%s/kernel_%04d.ptx", getenv("STUB_DIR"), count++);
    FILE *file = fopen((*module)->path, "w");
    if (!file || fputs(ptx, file) < 0 || fclose(file) != 0) {
        perror((*module)->path);
        return UNKNOWN;
    }
    return SUCCESS;
}

int cuModuleLoadDataEx(Module **module, const char *ptx, unsigned count, const int *options, void **values) {
    // Dr.Jit takes an empty log for a sign that the driver had the kernel in its cache.
    for (unsigned i = 0; i < count; ++i)
        if (options[i] == 3)
            strcpy(values[i], "stub");
    return cuModuleLoadData(module, ptx);
}

int cuModuleUnload(Module *module) { return SUCCESS; }

int cuModuleGetFunction(Function **function, Module *module, const char *name) {
    *function = calloc(1, sizeof(Function));
    (*function)->module = module;
    snprintf((*function)->name, sizeof((*function)->name), "%s", name);
    return SUCCESS;
}

int cuFuncSetAttribute(void *function, int attribute, int value) { return SUCCESS; }

int cuOccupancyMaxPotentialBlockSize(int *blocks, int *threads, void *function, void *shared, size_t bytes,
                                     int limit) {
    *blocks = 132;
    *threads = 128;
    return SUCCESS;
}

/// Translates a kernel and compiles that; false if it cannot be done, which the tools have then said why.
static int compile(Function *function) {
    const char *path = function->module->path, *name = function->name;
    char *command = NULL, *library = NULL;
    // Integers overflow, memory has no types, and no product is fused that is not written so. Nothing is
    // optimized: that would take longer than to run the kernel.
    if (asprintf(&library, "%s.%s.so", path, name) < 0 ||
        asprintf(&command,
                 "\"${PYTHON:-python3}\" \"$STUB_SOURCES/ptx2c.py\" '%s' '%s' '%s.c' && "
                 "\"${CC:-cc}\" -std=gnu11 -march=haswell -fwrapv -fno-strict-aliasing -ffp-contract=off "
                 "-fno-math-errno -w -shared -fPIC -I \"$STUB_SOURCES\" -o '%s' '%s.c' -lm",
                 path, name, library, library, library) < 0 ||
        system(command) != 0)
        return 0;
    void *loaded = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    function->launch = loaded ? dlsym(loaded, "launch") : NULL;
    if (!function->launch)
        fprintf(stderr, "%s\n", dlerror());
    free(command);
    free(library);
    return function->launch != NULL;
}

int cuLaunchKernel(Function *function, unsigned blocks, unsigned blocks_y, unsigned blocks_z,
                   unsigned threads, unsigned threads_y, unsigned threads_z, unsigned shared, void *stream,
                   void **parameters, void **extra) {
    if (!function->launch && !compile(function))
        return UNKNOWN;
    // Dr.Jit's own kernels have one parameter, and get it as a buffer: a 1, its address, and more.
    function->launch(parameters ? parameters : &extra[1], blocks, threads);
    return SUCCESS;
}

// --- What no kernel here needs ----------------------------------------------------------------------------

#define MISSING(name)                                                                                        \
    int name(void) {                                                                                         \
        fprintf(stderr, "The emulator has no " #name ".\n");                                                 \
        abort();                                                                                             \
    }
MISSING(cuArrayCreate_v2)
MISSING(cuArray3DCreate_v2)
MISSING(cuArray3DGetDescriptor_v2)
MISSING(cuArrayDestroy)
MISSING(cuMipmappedArrayCreate)
MISSING(cuMipmappedArrayGetLevel)
MISSING(cuMipmappedArrayDestroy)
MISSING(cuTexObjectCreate)
MISSING(cuTexObjectGetResourceDesc)
MISSING(cuTexObjectDestroy)
MISSING(cuSurfObjectCreate)
MISSING(cuSurfObjectDestroy)
MISSING(cuMemcpy2DAsync_v2)
MISSING(cuMemcpy3DAsync_v2)
MISSING(cuProfilerStart)
MISSING(cuProfilerStop)
MISSING(cuGraphicsGLRegisterBuffer)
MISSING(cuGraphicsGLRegisterImage)
MISSING(cuGraphicsUnregisterResource)
MISSING(cuGraphicsMapResources)
MISSING(cuGraphicsUnmapResources)
MISSING(cuGraphicsSubResourceGetMappedArray)
MISSING(cuGraphicsResourceGetMappedPointer)
