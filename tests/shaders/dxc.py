"""DXC, the compiler of HLSL, as a shared library: its C++ objects, called by the places of functions."""

import ctypes
import pathlib
import uuid

LIBRARY = pathlib.Path(__file__).parents[2] / ".venv-shaders/libdxcompiler_x86_64.so.3.7"
COMPILER = "73e22d93-e6ce-47f3-b5bf-f0664f39c1b0"
COMPILER_3 = "228b4687-5a6a-4730-900c-9702b2203f54"
RESULT = "58346cda-dde7-4497-9461-6f87af5e0659"
UTF_8 = 65001
# Places in the tables: each object has three functions of IUnknown and two destructors first.
COMPILE, GET_STATUS, GET_RESULT, GET_ERRORS, GET_POINTER, GET_SIZE = 5, 5, 6, 7, 5, 6
ARGUMENTS = ["-E", "main", "-T", "cs_6_0", "-spirv", "-fspv-target-env=vulkan1.1"]


class _Buffer(ctypes.Structure):
    _fields_ = [("text", ctypes.c_char_p), ("size", ctypes.c_size_t), ("encoding", ctypes.c_uint32)]


def _guid(text):
    return (ctypes.c_byte * 16).from_buffer_copy(uuid.UUID(text).bytes_le)


def _call(place, this, *arguments, result=ctypes.c_long):
    table = ctypes.cast(this, ctypes.POINTER(ctypes.POINTER(ctypes.c_void_p)))[0]
    types = [ctypes.c_uint32 if isinstance(argument, int) else ctypes.c_void_p for argument in arguments]
    return ctypes.CFUNCTYPE(result, ctypes.c_void_p, *types)(table[place])(this, *arguments)


def _bytes(place, result):
    blob = ctypes.c_void_p()
    _call(place, result, ctypes.c_void_p(ctypes.addressof(blob)))
    if not blob:
        return b""
    pointer = _call(GET_POINTER, blob, result=ctypes.c_void_p)
    return ctypes.string_at(pointer, _call(GET_SIZE, blob, result=ctypes.c_size_t))


def compiled(source):
    """The SPIR-V that DXC makes of a text."""
    library = ctypes.CDLL(str(LIBRARY))
    compiler, result = ctypes.c_void_p(), ctypes.c_void_p()
    failed = library.DxcCreateInstance(_guid(COMPILER), _guid(COMPILER_3), ctypes.byref(compiler))
    assert not failed, hex(failed)
    text = source.encode()
    buffer = _Buffer(text, len(text), UTF_8)
    words = (ctypes.c_wchar_p * len(ARGUMENTS))(*ARGUMENTS)
    interface = _guid(RESULT)
    pointers = [ctypes.c_void_p(ctypes.addressof(kept)) for kept in (buffer, words, interface, result)]
    failed = _call(
        COMPILE, compiler, pointers[0], pointers[1], len(ARGUMENTS), None, pointers[2], pointers[3]
    )
    assert not failed, hex(failed)
    status = ctypes.c_int32()
    _call(GET_STATUS, result, ctypes.c_void_p(ctypes.addressof(status)))
    assert status.value == 0, _bytes(GET_ERRORS, result).decode(errors="replace")
    return _bytes(GET_RESULT, result)
