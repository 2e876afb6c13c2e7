package badlog.plot.text

/** [value] with so many [decimals], rounded half away from zero as it is in binary. Only for what is below 1e15. */
internal expect fun fixedDigits(value: Double, decimals: Int): String

/** A finite [value] in powers of ten, with so many [decimals] before the `e`: `1.25e-7`, `-3e20`. */
internal expect fun exponentialDigits(value: Double, decimals: Int): String
