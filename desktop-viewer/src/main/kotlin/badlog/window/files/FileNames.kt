package badlog.window.files

import badlog.files.LogName
import badlog.files.safeName
import java.nio.file.Path

/** Returns [text] as the name of a file on any system. It has no forbidden characters, is not the name of a device, and is not too long. */
internal fun fileNameOf(text: String): String = text.map { if (it.isISOControl() || it in FORBIDDEN) '-' else it }
    .joinToString("")
    .trim(' ', '.')
    .take(MAX_LENGTH)
    .ifEmpty { "badlog" }
    .let(::safeName)

/** Returns the name of [file] without the endings of its format. */
internal fun stemOf(file: Path): String = fileNameOf(LogName.of(file.fileName.toString()).stem)

private const val FORBIDDEN = "\\/:*?\"<>|"
private const val MAX_LENGTH = 120
