package badlog.bag

/** The first [size] of these numbers; no copy where the platform can do without. This array is of no use afterwards. */
internal expect fun DoubleArray.shortened(size: Int): DoubleArray
