package badlog.core.bag

/** Returns the first [size] of these numbers, without a copy if the platform allows it. This array must not be used afterwards. */
internal expect fun DoubleArray.shortened(size: Int): DoubleArray
