package badlog.viewer.text

/** Returns [value] with [decimals] decimals; the exact binary value is rounded half away from zero. Only for magnitudes below 1e15. */
internal expect fun fixedDigits(value: Double, decimals: Int): String

/** Returns a finite [value] in powers of ten, with [decimals] decimals before the `e`: `1.25e-7`, `-3e20`. */
internal expect fun exponentialDigits(value: Double, decimals: Int): String
