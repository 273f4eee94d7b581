"""Arrays that are handed to kernels once and for all, instead of at every call.

numba unpacks every array of a NamedTuple at each call of a kernel, 0.4 us an array: 55 us for a system with its state.
A `Held` is such a tuple as kernels see it, kept in memory. A kernel that takes one receives an address, and
`held_values` gives it the tuple.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
from numba import typeof, types
from numba.core import cgutils
from numba.core.registry import cpu_target
from numba.extending import NativeValue, intrinsic, models, register_model, typeof_impl, unbox

from moorage._jit import kernel


class HeldType(types.Type):
    """Type of a `Held` for the compiler: that of its tuple."""

    def __init__(self, inner):
        self.inner = inner
        super().__init__(name=f"Held({inner})")


register_model(HeldType)(models.OpaqueModel)


class Held:
    """A tuple of arrays and numbers for kernels. The arrays are shared; numbers are those of the time it was made.

    Parameters
    ----------
    values : NamedTuple
        Of arrays, numbers and such tuples.
    """

    def __init__(self, values: Any):
        self.values = values
        self._numba_type_, size = _type_and_size(values)  # numba looks first here for the type
        self._memory = np.zeros(size // 8 + 1)
        self.address = self._memory.ctypes.data
        _fill(np.uint64(self.address), values)

    def __reduce__(self):
        """A copy has an address of its own, of copied arrays."""
        return Held, (self.values,)


def _type_and_size(values):
    """Return the type for a tuple, and the size of the tuple in memory, bytes.

    numba takes 2 ms to name the type of a large tuple, and 60 us to find it among those that it knows.
    """
    _fill(np.uint64(0), values)
    kind: Any = type(values)
    return _only_one(kind, len(_fill.signatures)) or _type_and_size_of(typeof(values))


@functools.cache
def _only_one(kind, _):
    """Return what belongs to the only known type of tuples of a class; None where there are several of it."""
    known = [signature[1] for signature in _fill.signatures if signature[1].instance_class is kind]
    return _type_and_size_of(known[0]) if len(known) == 1 else None


def _type_and_size_of(inner):
    context = cpu_target.target_context
    return HeldType(inner), context.get_abi_sizeof(context.get_value_type(inner))


@typeof_impl.register(Held)
def _type_of(held: Held, _):
    return held._numba_type_


@unbox(HeldType)
def _address_of(_, held, c):
    number = c.pyapi.object_getattr_string(held, "address")
    address = c.pyapi.long_as_voidptr(number)
    c.pyapi.decref(number)
    return NativeValue(address)


def _values_of(_, held):

    def generate(context, builder, signature, arguments):
        inner = signature.return_type
        values = builder.load(builder.bitcast(arguments[0], context.get_value_type(inner).as_pointer()))
        if context.enable_nrt:
            context.nrt.incref(builder, inner, values)
        return values

    return held.inner(held), generate


held_values: Any = intrinsic(_values_of)  # the tuple of a `Held`, in a kernel


def _put_at(_, address, values):
    def generate(context, builder, signature, arguments):
        place = builder.inttoptr(arguments[0], context.get_value_type(signature.args[1]).as_pointer())
        builder.store(arguments[1], place)
        return context.get_dummy_value()

    return types.void(address, values), generate


_put: Any = intrinsic(_put_at)


@kernel
def _fill(address, values):
    """Write a tuple to an address; to 0: nowhere."""
    if address != 0:
        _put(address, values)


class Snapshot:
    """Copies of contiguous arrays, to go back to; the arrays are copied as blocks of memory, 33 of them in 1 us.

    Parameters
    ----------
    arrays : list of array
        Kept by reference.
    """

    def __init__(self, arrays: list[np.ndarray]):
        self.arrays, self._copies = arrays, [a.copy() for a in arrays]
        assert all(a.flags.c_contiguous for a in arrays)
        here, there = ([a.ctypes.data for a in group] for group in (arrays, self._copies))
        sizes = [a.nbytes for a in arrays]
        self._keep = np.array([there, here, sizes], np.uint64).T.copy()
        self._return = np.array([here, there, sizes], np.uint64).T.copy()

    def __reduce__(self):
        """A copy keeps copied arrays."""
        return Snapshot, (self.arrays,)

    def keep(self) -> None:
        """Copy the arrays as they are now."""
        _copy_blocks(self._keep)

    def go_back(self) -> None:
        """Set the arrays to what they were when they were kept."""
        _copy_blocks(self._return)


def _copy_bytes(_, target, source, size):
    def generate(context, builder, signature, arguments):
        pointer = cgutils.voidptr_t
        target, source = (builder.inttoptr(a, pointer) for a in arguments[:2])
        cgutils.raw_memcpy(builder, target, source, arguments[2], 1)
        return context.get_dummy_value()

    return types.void(target, source, size), generate


_copy_block: Any = intrinsic(_copy_bytes)


@kernel
def _copy_blocks(table):
    """Copy blocks of memory: addresses to and from, and bytes."""
    for k in range(len(table)):
        _copy_block(table[k, 0], table[k, 1], table[k, 2])
