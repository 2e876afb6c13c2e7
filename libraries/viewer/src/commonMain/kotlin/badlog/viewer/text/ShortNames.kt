package badlog.viewer.text

/**
 * Returns the legend names of the topics [names], in order. Each is the shortest end of its path that distinguishes it from the others,
 * so that `Left/speed` and `Right/speed` are not both `speed`. Equal names get equal results.
 */
fun shortNames(names: List<String>): List<String> {
    val paths = names.distinct().associateWith { it.trim('/').split('/') }
    // Counts each end of a path once: each frame of a zoom may need a legend of sixty lines.
    val ends = HashMap<String, Int>()
    for (path in paths.values) for (parts in 1..path.size) ends[endOf(path, parts)] = (ends[endOf(path, parts)] ?: 0) + 1
    val short = paths.mapValues { (name, path) ->
        (1..path.size).map { endOf(path, it) }.firstOrNull { ends[it] == 1 } ?: name
    }
    return names.map { short.getValue(it) }
}

private fun endOf(path: List<String>, parts: Int) = path.takeLast(parts).joinToString("/")
