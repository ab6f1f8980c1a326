/* Stands in for libnvoptix.so.1, but traces no ray: scenes load, the PTX of kernels that trace is kept in
   STUB_DIR, and their launches do nothing. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SUCCESS = 0, UNSUPPORTED_ABI = 7801, UNKNOWN = 7999, COMPLETED = 0x2364 };

/// Whatever is made is an address that nobody looks at.
static void *something(void) {
    static int it;
    return &it;
}

static const char *error_text(int error) { return "an error of the emulator"; }
static int nothing(void) { return SUCCESS; }

static int context_create(void *cuda, void *options, void **context) {
    *context = something();
    return SUCCESS;
}

static int module_create(void *context, void *options, void *pipeline, const char *ptx, size_t size,
                         char *log, size_t *log_size, void **module) {
    static int count;
    char path[4096];
    snprintf(path, sizeof(path), "%s/optix_%04d.ptx", getenv("STUB_DIR"), count++);
    FILE *file = fopen(path, "w");
    if (!file || fwrite(ptx, 1, size, file) != size || fclose(file) != 0) {
        perror(path);
        return UNKNOWN;
    }
    if (log_size)
        *log_size = 0;
    *module = something();
    return SUCCESS;
}

static int module_create_with_tasks(void *context, void *options, void *pipeline, const char *ptx,
                                    size_t size, char *log, size_t *log_size, void **module, void **task) {
    *task = something();
    return module_create(context, options, pipeline, ptx, size, log, log_size, module);
}

static int module_state(void *module, int *state) {
    *state = COMPLETED;
    return SUCCESS;
}

static int builtin_module(void *context, void *options, void *pipeline, void *kind, void **module) {
    *module = something();
    return SUCCESS;
}

static int task_execute(void *task, void **more, unsigned most, unsigned *count) {
    *count = 0;
    return SUCCESS;
}

static int group_create(void *context, void *descriptions, unsigned count, void *options, char *log,
                        size_t *log_size, void **groups) {
    for (unsigned i = 0; i < count; ++i)
        groups[i] = something();
    if (log_size)
        *log_size = 0;
    return SUCCESS;
}

static int group_stack_size(void *group, unsigned *sizes) {
    memset(sizes, 0, 7 * sizeof(*sizes));
    return SUCCESS;
}

static int pipeline_create(void *context, void *compile, void *link, void **groups, unsigned count, char *log,
                           size_t *log_size, void **pipeline) {
    if (log_size)
        *log_size = 0;
    *pipeline = something();
    return SUCCESS;
}

static int memory_usage(void *context, void *options, void *inputs, unsigned count, size_t *sizes) {
    for (int i = 0; i < 3; ++i)
        sizes[i] = 4096;
    return SUCCESS;
}

static int build(void *context, void *stream, void *options, void *inputs, unsigned count, void *scratch,
                 size_t scratch_size, void *out, size_t size, uint64_t *handle, size_t **emitted,
                 unsigned emitted_count) {
    *handle = (uintptr_t)out;
    if (emitted_count > 0)
        *emitted[0] = 1024; // of the compacted structure
    return SUCCESS;
}

static int compact(void *context, void *stream, uint64_t handle, void *out, size_t size,
                   uint64_t *compacted) {
    *compacted = (uintptr_t)out;
    return SUCCESS;
}

static int pack_header(void *group, void *header) {
    memset(header, 0, 32);
    return SUCCESS;
}

/// The one function that a driver exports. It fills the table of all others.
int optixQueryFunctionTable(int abi, unsigned options, void *keys, void *values, void **table, size_t size) {
    if (abi != 105) // of which the places below are
        return UNSUPPORTED_ABI;
    for (size_t i = 0; i < size / sizeof(*table); ++i)
        table[i] = nothing;
    table[0] = table[1] = error_text;
    table[2] = context_create;
    table[12] = module_create;
    table[13] = module_create_with_tasks;
    table[14] = module_state;
    table[16] = builtin_module;
    table[17] = task_execute;
    table[18] = group_create;
    table[20] = group_stack_size;
    table[21] = pipeline_create;
    table[24] = memory_usage;
    table[25] = build;
    table[29] = compact;
    table[40] = pack_header;
    return SUCCESS;
}
