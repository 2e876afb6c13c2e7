package badlog.viewer.layout

import java.nio.file.InvalidPathException
import java.nio.file.Path

/** [file] as a layout writes it: relative to [folder] where it is in it, with `/` between the parts on every system. */
internal fun pathText(file: Path, folder: Path?): String {
    val base = folder?.toAbsolutePath()?.normalize()
    return if (base != null && file.startsWith(base)) base.relativize(file).joinToString("/") else file.toString()
}

/** The file that a layout wrote as [text], seen from [folder]; null where no file can be called that. */
internal fun pathOf(text: String, folder: Path?): Path? = try {
    (folder?.toAbsolutePath()?.resolve(text) ?: Path.of(text)).takeIf { it.isAbsolute }?.normalize()
} catch (_: InvalidPathException) {
    null
}
