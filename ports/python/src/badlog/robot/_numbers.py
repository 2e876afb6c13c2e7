"""Writes numbers in the same bytes as `jvm-robot`: by Java 17's `%.5g`, and with six decimals for an x axis."""

from __future__ import annotations

import math

# Nothing farther than this from a tie between two five-digit numbers can end up on its other side.
_TIE_DISTANCE = 1.0e-9

# A size; from there on, the power of ten that gives five digits before the point, and the decimals that are left.
_SCALES = ((1e4, 1.0, 0), (1e3, 1e1, 1), (1e2, 1e2, 2), (1e1, 1e3, 3), (1e0, 1e4, 4), (1e-1, 1e5, 5), (1e-2, 1e6, 6), (1e-3, 1e7, 7), (1e-4, 1e8, 8))

_FEW_BITS = 1 << 20
_UNIT = 4_940_656_458_412  # 2^-1074 is 4940656458412.4654417657 times 10^-336
_UNIT_REST = 4_654_417_657
_UNIT_REST_SCALE = 10_000_000_000


def five_digits(value: float) -> str:
    """The number with five significant digits, as `String.format(Locale.ROOT, "%.5g", value)` on Java 17 writes it."""
    magnitude = abs(value)
    if 1.0e-4 <= magnitude < 1.0e5:
        for size, power, decimals in _SCALES:
            if magnitude >= size:
                break
        scaled = magnitude * power
        digits = int(scaled + 0.5)
        if abs(scaled - digits) < 0.5 - _TIE_DISTANCE and (digits < 100_000 or decimals > 0):
            return "%.*f" % (decimals - (digits == 100_000), value)
    elif value == 0.0:
        return "-0.0000" if math.copysign(1.0, value) < 0 else "0.0000"
    elif value != value:
        return "NaN"
    elif magnitude == math.inf:
        return "Infinity" if value > 0 else "-Infinity"
    return ("-" if value < 0 else "") + _text_of(*_rounded(magnitude))


def microseconds(value: float) -> str:
    """The number with six decimals: `%.5g` only resolves 10 ms from 100 s on."""
    magnitude = abs(value)
    if not magnitude < 9.0e18:
        return five_digits(value)
    whole = int(magnitude)
    millionths = int((magnitude - whole) * 1_000_000 + 0.5)
    if millionths == 1_000_000:
        whole += 1
        millionths = 0
    sign = "-" if value < 0 and (whole > 0 or millionths > 0) else ""
    return f"{sign}{whole}.{millionths:06d}"


def _text_of(digits: int, exponent: int) -> str:
    text = str(digits)
    if exponent == 4:
        return text
    if 0 <= exponent < 4:
        return f"{text[: exponent + 1]}.{text[exponent + 1 :]}"
    if -4 <= exponent < 0:
        return f"0.{'0' * (-exponent - 1)}{text}"
    return f"{text[0]}.{text[1:]}e{'-' if exponent < 0 else '+'}{abs(exponent):02d}"


def _rounded(magnitude: float) -> tuple[int, int]:
    """Five digits, and the decimal exponent of the first.

    Java first generates digits of the value until the rest is within a margin, half the distance to the next double (for a power of two, half of that
    again), then rounds these digits half up. So a value rounds up if value plus margin is above the tie.
    """
    fraction, exponent = math.frexp(magnitude)
    shift = min(53, exponent + 1074)
    significand = int(math.ldexp(fraction, shift))
    unit = exponent - shift
    if unit == -1074 and significand < _FEW_BITS:
        return _rounded_of_few_bits(significand)
    if significand & (significand - 1) == 0:
        reach, unit = 4 * significand + 1, unit - 2
    else:
        reach, unit = 2 * significand + 1, unit - 1
    decimal = math.floor((reach.bit_length() - 1 + unit) * math.log10(2))
    digits = _scaled(reach, unit, 4 - decimal)
    if digits >= 100_000:
        decimal += 1
        digits = _scaled(reach, unit, 4 - decimal)
    return digits, decimal


def _scaled(reach: int, unit: int, power: int) -> int:
    """`reach * 2^unit * 10^power`, rounded to the nearest, a tie down."""
    above: int = reach * 10 ** max(power, 0) << max(unit, 0)
    below: int = 10 ** max(-power, 0) << max(-unit, 0)
    return -((below - 2 * above) // (2 * below))


def _rounded_of_few_bits(units: int) -> tuple[int, int]:
    """Subnormal values of so few bits that the margin reaches into the five digits. They are generated one by one, as in Java."""
    scaled = units * _UNIT + units * _UNIT_REST // _UNIT_REST_SCALE
    margin = _UNIT // 4 if units & (units - 1) == 0 else _UNIT // 2
    place = 10**18
    # Java's first digit is zero if the value is below a power of ten within the margin.
    while place > scaled + margin:
        place //= 10
    while True:
        place //= 10
        rest = scaled % place
        if rest <= margin or place - rest <= margin:
            break
    is_up = place - rest <= margin and (rest > margin or rest > place - rest)
    generated = scaled - rest + (place if is_up else 0)
    unit = 10**14
    decimal = 18 - 336
    while unit * 10_000 > generated:
        unit //= 10
        decimal -= 1
    digits = (generated + unit // 2) // unit
    return (10_000, decimal + 1) if digits == 100_000 else (digits, decimal)
