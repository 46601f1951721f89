"""Arrays as text for a page: quantised, differenced, compressed. The page's twin of the way back is viewer/src/data.js.

A series is F frames of R rows of N nodes. What is stored is the difference in time of the difference from node to node:
cloth moves smoothly, so most of these are small. They wrap around, so nothing is lost beyond the quantisation.
"""

from __future__ import annotations

import base64
import zlib
from dataclasses import dataclass

import numpy as np

LEVELS_16, LEVELS_8 = 65535, 255


@dataclass(frozen=True)
class Quantised:
    """value = low + code · quantum, code an unsigned integer; values beyond the range have the code at its end."""

    codes: np.ndarray  # unsigned integers, shape of the values
    low: np.ndarray  # one number, or one a component
    quantum: float  # in the unit of the values

    @property
    def values(self) -> np.ndarray:
        return self.low + self.codes * self.quantum


def quantise_positions(position: np.ndarray) -> Quantised:
    """Positions (F, N, 3) [m] to 16 bits: one quantum for all axes, the largest side of all frames' box by 65,535."""
    low = position.min(axis=(0, 1))
    quantum = max(float((position.max(axis=(0, 1)) - low).max()) / LEVELS_16, 1e-12)
    return Quantised(np.rint((position - low) / quantum).astype(np.uint16), low, quantum)


def quantise_field(values: np.ndarray, low: float, high: float) -> Quantised:
    """Values to 8 bits between `low` and `high`; those beyond are cut, those that are no numbers are drawn as `low`."""
    quantum = (high - low) / LEVELS_8
    codes = np.rint((np.nan_to_num(values, nan=low) - low) / quantum)
    return Quantised(np.clip(codes, 0, LEVELS_8).astype(np.uint8), np.array(low), quantum)


def pack_series(codes: np.ndarray) -> str:
    """(F, R, N) of uint16 or uint8."""
    signed = np.dtype(f"int{8 * codes.itemsize}")
    change = codes.copy()
    change[1:] -= codes[:-1]
    slope = change.copy()
    slope[..., 1:] -= change[..., :-1]
    slope = slope.view(signed)
    folded = (slope << 1) ^ (slope >> (8 * codes.itemsize - 1))  # 0, -1, 1, -2, ... to 0, 1, 2, 3, ...
    planes = np.ascontiguousarray(folded).reshape(-1).view(np.uint8).reshape(-1, codes.itemsize).T  # low bytes first
    return _pack(planes.tobytes())


def unpack_series(text: str, shape: tuple[int, int, int], itemsize: int) -> np.ndarray:
    """The codes that `pack_series` was given."""
    unsigned = np.dtype(f"uint{8 * itemsize}")
    planes = np.frombuffer(_unpack(text), dtype=np.uint8).reshape(itemsize, -1)
    folded = np.ascontiguousarray(planes.T).view(unsigned).reshape(shape)
    slope = (folded >> 1) ^ (np.zeros_like(folded) - (folded & 1))
    return np.cumsum(np.cumsum(slope, axis=2, dtype=unsigned), axis=0, dtype=unsigned)


def pack_array(array: np.ndarray, kind: str) -> str:
    """`kind`: "<f4" or "<u4", as the page reads it."""
    return _pack(np.ascontiguousarray(array, dtype=kind).tobytes())


def unpack_array(text: str, kind: str) -> np.ndarray:
    return np.frombuffer(_unpack(text), dtype=kind)


def _pack(data: bytes) -> str:
    deflate = zlib.compressobj(9, zlib.DEFLATED, -15)  # raw: no header, no checksum
    return base64.b64encode(deflate.compress(data) + deflate.flush()).decode("ascii")


def _unpack(text: str) -> bytes:
    return zlib.decompress(base64.b64decode(text), -15)
