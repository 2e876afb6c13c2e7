package badlog.core.bag

// Memory that a browser reserved but never wrote to costs nothing; a copy of a large log would.
internal actual fun DoubleArray.shortened(size: Int): DoubleArray =
    if (size > this.size / 2) asDynamic().subarray(0, size).unsafeCast<DoubleArray>() else copyOf(size)
