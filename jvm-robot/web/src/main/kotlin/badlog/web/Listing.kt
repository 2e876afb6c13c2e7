package badlog.web

import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.name

/**
 * The content of a folder, in the form of WPILib's own web server, with times of modification.
 *
 * @property folders the names of its folders.
 * @property files its logs.
 */
internal class Listing(private val folders: List<String>, private val files: List<ListedFile>) {
    /** Returns the listing as JSON in ASCII. */
    fun toJson(): String = buildString {
        append("{\"dirs\":[")
        folders.sorted().forEachIndexed { i, name ->
            if (i > 0) append(',')
            append("{\"name\":").appendQuoted(name).append('}')
        }
        append("],\"files\":[")
        files.sortedBy { it.path.name }.forEachIndexed { i, file ->
            if (i > 0) append(',')
            append("{\"name\":").appendQuoted(file.path.name)
            append(",\"size\":").append(file.size).append(",\"modified\":").append(file.modified).append('}')
        }
        append("]}")
    }

    private companion object {
        fun StringBuilder.appendQuoted(text: String) = apply {
            append('"')
            for (character in text) {
                // Names may contain any character, even one that ends a string, a script or a line.
                if (character.isPlain()) append(character) else append("\\u").append(character.code.toString(16).padStart(4, '0'))
            }
            append('"')
        }

        fun Char.isPlain() = this in ' '..'~' && this !in "\"\\<>&"
    }
}

/**
 * A log in a folder.
 *
 * @property size its length in bytes.
 * @property modified the time of its last write, in ms since 1970.
 */
internal class ListedFile(val path: Path, val size: Long, val modified: Long) {
    constructor(path: Path, attributes: BasicFileAttributes) : this(path, attributes.size(), attributes.lastModifiedTime().toMillis())

    /** The HTTP entity tag (ETag), made from its size and the time of its last write. */
    val tag: String get() = "\"${modified.toString(16)}-${size.toString(16)}\""
}
