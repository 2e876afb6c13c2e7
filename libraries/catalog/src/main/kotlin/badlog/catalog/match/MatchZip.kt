package badlog.catalog.match

import badlog.files.LogName
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.files.safeName
import badlog.files.writing
import badlog.signals.match.files.MatchManifest
import badlog.signals.match.files.isNameInside
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipFile

/**
 * The logs in the ZIP [file], which may have come from anywhere: a name from the ZIP leads nowhere but into a folder of badlog, links are
 * files like others, and whatever grows without end is refused.
 *
 * @throws NotReadException if it is not a ZIP, or not one that people make of logs.
 */
internal class MatchZip(private val file: Path) : AutoCloseable {
    private val zip: ZipFile = try {
        ZipFile(file.toFile())
    } catch (_: IOException) {
        throw refused("This is not a ZIP that can be read; make it again.")
    } catch (_: IllegalArgumentException) {
        throw refused("This is not a ZIP that can be read; make it again.")
    }
    private val entries: List<ZipEntry> = try {
        checked(zip.entries().asSequence())
    } catch (e: Throwable) {
        zip.close()
        throw e
    }

    /** Whether anything in it may be a log. */
    val hasLogs: Boolean get() = entries.any { isManifest(it.name) || LogName.of(it.name.substringAfterLast('/')).ending.isNotEmpty() }

    /** The text of its `match.json`; null if there is none. */
    fun manifest(): String? = entries.filter { isManifest(it.name) }.minByOrNull { it.name.length }
        ?.let { textOf(it) }

    /**
     * Writes its logs into [folder], and returns them by their names in the ZIP.
     *
     * @param checkpoint called after each piece; may throw to cancel.
     */
    fun unpack(folder: Path, checkpoint: () -> Unit): Map<String, Path> {
        val outer = entries.firstOrNull { isManifest(it.name) }?.name?.removeSuffix(MatchManifest.NAME).orEmpty()
        val folders = LinkedHashMap<String, Path>()
        var bytes = 0L
        return entries.filterNot { isManifest(it.name) }.filter { isWanted(it.name) }.associate { entry ->
            val parent = entry.name.substringBeforeLast('/', "")
            val place = folders.getOrPut(parent) {
                writing(folder) { Files.createDirectory(folder.resolve("${folders.size}")) }
            }
            val target = place.resolve(safeName(entry.name.substringAfterLast('/')))
            bytes += copy(entry, target, ALL_BYTES - bytes, checkpoint)
            entry.name.removePrefix(outer) to target
        }
    }

    override fun close(): Unit = zip.close()

    private fun copy(entry: ZipEntry, target: Path, most: Long, checkpoint: () -> Unit): Long {
        val piece = ByteArray(1 shl 16)
        var size = 0L
        val stream = try {
            zip.getInputStream(entry)
        } catch (_: IOException) {
            throw damaged(entry)
        }
        stream.use {
            writing(target) { Files.newOutputStream(target) }.use { out ->
                while (true) {
                    val count = try {
                        stream.read(piece)
                    } catch (_: IOException) {
                        throw damaged(entry)
                    }
                    if (count < 0) return size
                    size += count
                    // The sizes that a ZIP names may be wrong.
                    if (size > most) throw tooLarge()
                    if (size > RATIO_COUNTS_FROM && size / RATIO > entry.compressedSize) throw grows(entry)
                    writing(target) { out.write(piece, 0, count) }
                    checkpoint()
                }
            }
        }
    }

    private fun textOf(entry: ZipEntry): String {
        val bytes = try {
            zip.getInputStream(entry).use { it.readNBytes(MANIFEST_BYTES + 1) }
        } catch (_: IOException) {
            throw damaged(entry)
        }
        if (bytes.size > MANIFEST_BYTES) throw refused("Its ${MatchManifest.NAME} is far too large; write a new one.")
        return bytes.decodeToString()
    }

    private fun checked(all: Sequence<ZipEntry>): List<ZipEntry> {
        if (zip.size() > FILES) throw refused("It has more than $FILES files; make a ZIP of one match only.")
        val seen = HashSet<String>()
        val files = ArrayList<ZipEntry>()
        var bytes = 0L
        for (entry in all) {
            if (!isNameInside(entry.name.removeSuffix("/"))) {
                throw refused("“${shown(entry)}” in it is not the name of a file in a ZIP; make the ZIP again from the folder.")
            }
            // Windows and macOS would take both for the same file.
            if (!seen.add(entry.name.trimEnd('/').lowercase())) {
                throw refused("It has two files called “${shown(entry)}”; make the ZIP again from the folder.")
            }
            if (entry.isDirectory || isHidden(entry.name)) continue
            bytes += maxOf(0, entry.size)
            if (bytes > ALL_BYTES) throw tooLarge()
            if (entry.size > RATIO_COUNTS_FROM && entry.size / RATIO > entry.compressedSize) throw grows(entry)
            files += entry
        }
        return files
    }

    private fun refused(sentence: String) = NotReadException(ReadResult.NotRead.noLog(file, sentence))

    private fun damaged(entry: ZipEntry) = refused("“${shown(entry)}” in it is damaged; make the ZIP again.")

    private fun grows(entry: ZipEntry) =
        refused("“${shown(entry)}” in it grows more than $RATIO times when it is read, as no log does; leave it out.")

    private fun tooLarge() = refused("Its files have more than ${ALL_BYTES shr 30} GB together; make a ZIP of one match only.")

    private fun shown(entry: ZipEntry) = entry.name.take(MAX_SHOWN)

    private fun isManifest(name: String) = name.substringAfterLast('/') == MatchManifest.NAME

    private fun isWanted(name: String) = LogName.of(name.substringAfterLast('/')).ending.isNotEmpty() || isVideo(name)

    private companion object {
        const val FILES = 500
        const val ALL_BYTES = 8L shl 30
        const val MANIFEST_BYTES = 1 shl 20
        const val MAX_SHOWN = 100

        /** As in packs of rules: numbers become ten times smaller, and only zeros a thousand times. */
        const val RATIO = 200L
        const val RATIO_COUNTS_FROM = 1L shl 20
    }
}

/** Returns whether a file called [name] is hidden, or one that macOS adds to a ZIP. */
private fun isHidden(name: String): Boolean = name.split('/').any { it.startsWith(".") || it == "__MACOSX" }
