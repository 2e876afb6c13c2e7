package badlog.viewer.takeaway.figure

/**
 * The points of [frame]'s lines as columns: `x`, `y`, the number of their `line` as a text, and of their `piece`.
 *
 * @property strokes what is joined.
 * @property dots what deserves a dot: every point of few, and what stands alone between two gaps.
 */
internal class LinePoints(frame: FigureFrame) {
    val strokes: Map<String, List<Any>>
    val dots: Map<String, List<Any>>

    init {
        val joined = Columns()
        val alone = Columns()
        var pieceNumber = 0
        frame.lines.forEachIndexed { i, line ->
            for (piece in line.pieces) {
                pieceNumber++
                if (piece.x.size > 1) joined.add(piece, i, pieceNumber)
            }
            alone.add(line.dots, i, pieceNumber)
        }
        strokes = joined.all
        dots = alone.all
    }

    private class Columns {
        private val x = ArrayList<Double>()
        private val y = ArrayList<Double>()
        private val line = ArrayList<String>()
        private val piece = ArrayList<Int>()

        val all: Map<String, List<Any>> = mapOf("x" to x, "y" to y, "line" to line, "piece" to piece)

        fun add(points: FigurePiece, lineNumber: Int, pieceNumber: Int) {
            val name = lineNumber.toString()
            for (i in points.x.indices) {
                x += points.x[i]
                y += points.y[i]
                line += name
                piece += pieceNumber
            }
        }
    }
}
