package badlog.site.picture

/** At most 256 colors for pictures, the most frequent ones. Every other color becomes the nearest of them. */
internal class Palette private constructor(val colors: List<Int>) {
    private val places = HashMap<Int, Int>().apply { colors.forEachIndexed { i, color -> put(color, i) } }

    /** Returns the index in [colors] for [color]; transparency is ignored. */
    fun indexOf(color: Int): Int = places.getOrPut(color and RGB) { colors.indices.minBy { distance(colors[it], color) } }

    private fun distance(a: Int, b: Int): Int = listOf(0, 8, 16).sumOf { shift ->
        ((a shr shift and 0xFF) - (b shr shift and 0xFF)).let {
            it *
                it
        }
    }

    internal companion object {
        private const val RGB = 0xFFFFFF
        private const val MAX_COLORS = 256

        /** Returns the palette of [pictures], each a list of pixels. */
        fun of(pictures: List<IntArray>): Palette {
            val counts = HashMap<Int, Int>()
            for (pixels in pictures) for (pixel in pixels) counts.merge(pixel and RGB, 1, Int::plus)
            return Palette(
                counts.entries.sortedWith(
                    compareByDescending<Map.Entry<Int, Int>> {
                        it.value
                    }.thenBy { it.key },
                ).take(MAX_COLORS).map { it.key },
            )
        }
    }
}
