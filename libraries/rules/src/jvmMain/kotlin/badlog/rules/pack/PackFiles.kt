package badlog.rules.pack

import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * The files of a pack, which may have come from anywhere. Nothing outside the pack is read, and nothing that exceeds [PackLimits].
 *
 * @property names their paths within the pack, with slashes, in order; without hidden files.
 */
internal interface PackFiles : AutoCloseable {
    val names: List<String>

    /** Returns the content of the file [name], one of [names]; at most [PackLimits.FILE_BYTES] bytes. */
    fun bytes(name: String): ByteArray

    override fun close()

    companion object {
        /**
         * Returns the files of the folder or zip [pack].
         *
         * @throws PackException if there is none, or something in it is not allowed in a pack.
         */
        fun of(pack: Path): PackFiles = try {
            when {
                Files.isSymbolicLink(pack) -> throw PackException("$pack is a link; name the pack itself.")
                Files.isDirectory(pack) -> PackFolder(pack)
                Files.isRegularFile(pack) -> PackZip(pack)
                else -> throw PackException("There is no pack $pack; check the spelling, or begin it with badlog rules new.")
            }
        } catch (e: IOException) {
            throw PackException("$pack cannot be read (${e.message}); check its permissions.")
        }
    }
}

/** The limits for the content of a pack. */
internal object PackLimits {
    /** The maximum size of a file, in bytes. Some seconds of a log have a few megabytes. */
    const val FILE_BYTES = 32 shl 20

    /** The maximum total size of all files, in bytes. */
    const val ALL_BYTES = 256L shl 20

    /** The maximum number of files. */
    const val FILES = 1000

    /** The maximum number of names in the path of a file within the pack; the path of a slice has three. */
    const val DEPTH = 4

    /** The maximum ratio by which a zip may shrink a file. Numbers shrink to a tenth, and only zeros to a thousandth. */
    const val RATIO = 200L

    /** The maximum size, in bytes, of a file for which [RATIO] does not apply. */
    const val RATIO_COUNTS_FROM = 1L shl 20
}

/** Returns whether a file called [name] is hidden, or one that macOS adds to a zip. */
internal fun isHidden(name: String): Boolean = name.split('/').any { it.startsWith(".") || it == "__MACOSX" }

/**
 * Returns the bytes of this stream, the file [name] in [pack].
 *
 * @throws PackException if there are more than [PackLimits.FILE_BYTES].
 */
internal fun InputStream.readWithin(pack: Path, name: String): ByteArray = use { stream ->
    val bytes = stream.readNBytes(PackLimits.FILE_BYTES + 1)
    if (bytes.size > PackLimits.FILE_BYTES) throw tooLarge(pack, name)
    bytes
}

internal fun tooLarge(pack: Path, name: String) =
    PackException("“$name” in $pack is larger than ${PackLimits.FILE_BYTES shr 20} MB; cut a shorter slice.")

internal fun tooManyFiles(pack: Path) =
    PackException("$pack has more than ${PackLimits.FILES} files; keep in it only rules, signals, devices and slices.")

internal fun tooLargeTogether(pack: Path) =
    PackException("The files of $pack have more than ${PackLimits.ALL_BYTES shr 20} MB together; keep fewer or shorter slices.")
