package badlog.core.bag

internal actual fun DoubleArray.shortened(size: Int): DoubleArray = copyOf(size)
