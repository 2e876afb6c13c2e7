package badlog.report

import badlog.files.LogFile

/** Returns a name in tables for each of [files]. It is the file name or, if several have the same, the path in their common folder. */
internal fun shortNames(files: List<LogFile>): Map<LogFile, String> = files.groupBy { it.name }.values.flatMap { alike ->
    if (alike.size == 1) return@flatMap listOf(alike[0] to alike[0].name)
    val paths = alike.map { it.path.toAbsolutePath().normalize() }
    var common = paths[0].parent
    while (!paths.all { it.startsWith(common) }) common = common.parent ?: return@flatMap alike.map { it to it.path.toString() }
    alike.mapIndexed { index, file -> file to common.relativize(paths[index]).toString() }
}.toMap()

/** Returns the longest beginning of [text] that takes at most [bytes] bytes in UTF-8, for a file name. */
fun startOfBytes(text: String, bytes: Int): String {
    var end = minOf(text.length, bytes)
    while (text.substring(0, end).encodeToByteArray().size > bytes || (end > 0 && text[end - 1].isHighSurrogate())) end--
    return text.substring(0, end)
}
