"""SI prefixes for axes and labels."""

from __future__ import annotations

import math

PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M"}


def scale_for(largest: float) -> tuple[float, str]:
    """(factor, prefix) that brings `largest` between 1 and 1000: values are multiplied by the factor."""
    if not math.isfinite(largest) or largest <= 0:
        return 1.0, ""
    exponent = 3 * math.floor(math.log10(largest) / 3 + 1e-9)
    exponent = min(max(exponent, min(PREFIXES)), max(PREFIXES))
    return 10.0**-exponent, PREFIXES[exponent]


def percent(ratio: float) -> str:
    """0.0234 -> "2.3 %", 7.69 -> "769 %"."""
    value = 100 * ratio
    return f"{value:.2g} %" if abs(value) < 99.5 else f"{value:.0f} %"


def quantity(value: float, unit: str, digits: int = 3) -> str:
    """0.000031, "m" -> "31 µm"."""
    factor, prefix = scale_for(abs(value))
    return f"{value * factor:.{digits}g} {prefix}{unit}"
