package badlog.viewer.draw.pen

/** A growing list of places, x and y alternating, without an allocation for each place. It is reused for the next drawing. */
class Points {
    /** The numbers, in the first [size] entries. */
    var values: DoubleArray = DoubleArray(FIRST)
        private set

    /** The number of used entries in [values]: two for each place. */
    var size: Int = 0
        private set

    /** Adds the place ([x], [y]). */
    fun add(x: Double, y: Double): Points {
        if (size == values.size) values = values.copyOf(size * 2)
        values[size++] = x
        values[size++] = y
        return this
    }

    /** Adds both ends of a line. */
    fun line(fromX: Double, fromY: Double, toX: Double, toY: Double): Points = add(fromX, fromY).add(toX, toY)

    fun clear(): Points {
        size = 0
        return this
    }

    private companion object {
        const val FIRST = 32
    }
}
