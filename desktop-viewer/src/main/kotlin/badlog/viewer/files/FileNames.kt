package badlog.viewer.files

import java.nio.file.Path

/** [text] as a part of a file's name on any system: without what they forbid, and not too long. */
internal fun fileNameOf(text: String): String = text.map { if (it.isISOControl() || it in FORBIDDEN) '-' else it }
    .joinToString("")
    .trim(' ', '.')
    .take(LONGEST)
    .ifEmpty { "badlog" }

/** The name of [file] without what tells its format. */
internal fun stemOf(file: Path): String {
    var name = file.fileName.toString()
    for (ending in ENDINGS) if (name.endsWith(ending, ignoreCase = true)) name = name.dropLast(ending.length)
    return fileNameOf(name)
}

private const val FORBIDDEN = "\\/:*?\"<>|"
private const val LONGEST = 120
private val ENDINGS = listOf(".gz", ".bag", ".badbag", ".csv", ".wpilog")
