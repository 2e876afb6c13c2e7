package badlog.viewer.shown.comparison

/**
 * What a log may be called.
 *
 * @property event the event; null if that is unknown.
 * @property match the match within its event, such as `Qualification 42`; null if that is unknown.
 * @property label its name for people if it stands alone.
 * @property path its file, with as many of its folders as are known, separated by `/`.
 */
class LogName(val event: String?, val match: String?, val label: String, val path: String)

/**
 * Returns the names of [logs] beside each other, in order: only the match if all are of the same event, with the file's name if names would
 * be equal, and with as many of its folders as tell files of one name apart.
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

/** Returns [label] in at most [letters], shortened in the middle if necessary: matches of one event differ at their end. */
fun shortLabel(label: String, letters: Int): String {
    if (label.length <= letters) return label
    val end = (letters - 1) / 2
    return label.take(letters - 1 - end).trimEnd() + "…" + label.takeLast(end).trimStart()
}
