/* plugins/spherecap.so, the file that Mitsuba loads: it refuses any Mitsuba but the one that the emitter, in
   the file beside it, was compiled for, and then loads the emitter.

   Mitsuba compares no versions. In another one the emitter would lack symbols, which ends the process, or
   have classes of another layout; so this file needs nothing of Mitsuba's, and asks by names that are looked
   up. */

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include <dlfcn.h>

// Mitsuba's own declaration has types of Mitsuba's; this file only hands on what it gets.
using Register = void (*)();
using InitPlugin = void (*)(std::string_view, Register);

/// What the emitter was compiled for, and what to do elsewhere. The Python package reads both from this file.
static constexpr char About[] =
    "spherecap plugin for Mitsuba " MITSUBA_WHEEL_VERSION "\0"
    "install mitsuba==" MITSUBA_WHEEL_VERSION "; or, where one of Mitsuba " SPHERECAP_MITSUBAS
    " is installed, spherecap again, by `pip install --no-build-isolation .` in its repository.";

/// "Mitsuba version 3.9.1 (master[...", or nothing.
static std::string info_build() {
    void *mitsuba = dlopen("libmitsuba.so", RTLD_LAZY | RTLD_NOLOAD);
    if (!mitsuba)
        return "";
    if (void *function = dlsym(mitsuba, "_ZN7mitsuba4util10info_buildB5cxx11Ei"))
        return reinterpret_cast<std::string (*)(int)>(function)(1);
    // Wheels up to 3.7 have the string of GCC before 5: a pointer to its characters, here never released.
    struct OldString {
        const char *text;
        ~OldString() {} // so that it is returned as a class with a destructor is
    };
    if (void *function = dlsym(mitsuba, "_ZN7mitsuba4util10info_buildEi"))
        return reinterpret_cast<OldString (*)(int)>(function)(1).text;
    return "";
}

/// The version of the running Mitsuba; empty if it does not tell.
static std::string running() {
    const std::string build = info_build(), prefix = "Mitsuba version ";
    if (build.compare(0, prefix.size(), prefix) != 0)
        return "";
    return build.substr(prefix.size(), build.find(' ', prefix.size()) - prefix.size());
}

static std::string refusal(const std::string &version) {
    return "The spherecap plugin was built for Mitsuba " MITSUBA_WHEEL_VERSION ", but this is " +
           (version.empty() ? "one that does not tell its version" : "Mitsuba " + version) + ": " +
           (About + std::strlen(About) + 1);
}

/// What Mitsuba calls, since 3.7.
extern "C" void init_plugin(std::string_view name, Register register_plugin) {
    const std::string version = running();
    if (version != MITSUBA_WHEEL_VERSION)
        throw std::runtime_error(refusal(version));

    Dl_info self;
    dladdr(About, &self);
    const std::string path = self.dli_fname;
    const std::string emitter = path.substr(0, path.rfind('/') + 1) + "spherecap_emitter.so";
    void *library = dlopen(emitter.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void *function = library ? dlsym(library, "init_plugin") : nullptr;
    if (!function)
        throw std::runtime_error("The spherecap emitter cannot be loaded, build it again: " +
                                 std::string(dlerror()));
    reinterpret_cast<InitPlugin>(function)(name, register_plugin);
}

/// What older ones call. An exception would have them release memory twice, so the refusal is printed. Then
/// they are given the name of a class that they cannot make an object of, which they say in an exception of
/// theirs.
extern "C" const char *plugin_name() {
    std::fprintf(stderr, "%s\n", refusal(running()).c_str());
    return "Emitter";
}
extern "C" const char *plugin_descr() { return ""; }
