package badlog.viewer.shown.comparison

/**
 * The possible names of a log.
 *
 * @property event the event; null if unknown.
 * @property match the match within its event, such as `Qualification 42`; null if unknown.
 * @property label the displayed name of the log alone.
 * @property path the path of the file, with all known folders, separated by `/`.
 */
class LogName(val event: String?, val match: String?, val label: String, val path: String)

/**
 * Returns the names of [logs] beside each other, in order. A name is only the match if all logs are of the same event. Equal names are
 * followed by the files' names, with as many folders as distinguish them.
 */
fun namesBeside(logs: List<LogName>): List<String> {
    val isOneEvent = logs.mapNotNull { it.event }.distinct().size <= 1
    val names = logs.map { log -> log.match?.takeIf { isOneEvent } ?: log.label }
    if (names.areDistinct) return names
    val paths = logs.map { it.path.split('/') }
    val ends = (1..paths.maxOf { it.size }).asSequence().map { depth -> paths.map { it.takeLast(depth).joinToString("/") } }
    val files = ends.firstOrNull { it.areDistinct } ?: ends.last()
    return names.mapIndexed { i, name -> "$name (${files[i]})" }
}

private val List<String>.areDistinct get() = distinct().size == size

/** Returns [label] in at most [letters] characters, shortened in the middle if necessary. Matches of one event differ at their end. */
fun shortLabel(label: String, letters: Int): String {
    if (label.length <= letters) return label
    val end = (letters - 1) / 2
    return label.take(letters - 1 - end).trimEnd() + "…" + label.takeLast(end).trimStart()
}
