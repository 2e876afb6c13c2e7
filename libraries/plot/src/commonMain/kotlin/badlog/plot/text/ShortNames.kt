package badlog.plot.text

/**
 * What a legend calls the topics [names], in their order: each by as little of the end of its path as tells it from the others, so that
 * `Left/speed` and `Right/speed` do not both read `speed`. The same name twice is called the same.
 */
public fun shortNames(names: List<String>): List<String> {
    val paths = names.distinct().associateWith { it.trim('/').split('/') }
    // How often each end of a path occurs: a legend of sixty lines is asked for in each frame of a zoom.
    val ends = HashMap<String, Int>()
    for (path in paths.values) for (parts in 1..path.size) ends[endOf(path, parts)] = (ends[endOf(path, parts)] ?: 0) + 1
    val short = paths.mapValues { (name, path) ->
        (1..path.size).map { endOf(path, it) }.firstOrNull { ends[it] == 1 } ?: name
    }
    return names.map { short.getValue(it) }
}

private fun endOf(path: List<String>, parts: Int) = path.takeLast(parts).joinToString("/")
