package badlog.viewer.choices.board

import badlog.viewer.shown.search.Query

/**
 * Returns the XY plots that a search for [text] offers beside the topics. “voltage over current” offers each match of “voltage” in [names]
 * over each match of “current”, as many as a person can choose from. There are none without the word “over” between two searches.
 *
 * @param names the topics with samples that are numbers, in the order of the list.
 */
fun xyGraphs(names: List<String>, text: String): List<BoardGraph> {
    val sides = OVER.split(text)
    if (sides.size != 2) return emptyList()
    val (ys, xs) = sides.map { side ->
        val query = Query(side)
        if (query.isEmpty) emptyList() else names.filter { query.matches(it) }
    }
    return ys.asSequence().flatMap { y -> xs.asSequence().filter { it != y }.map { x -> xyGraph(y, x) } }.take(MAX_OFFERED).toList()
}

private fun xyGraph(y: String, x: String) = BoardGraph(0, "$y over $x", listOf(x, y), isXy = true)

private val OVER = Regex("\\s+over\\s+", RegexOption.IGNORE_CASE)
private const val MAX_OFFERED = 20
