package badlog.catalog.match

import badlog.files.LogName
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.files.reading
import badlog.files.safeName
import badlog.files.writing
import badlog.signals.match.files.MatchManifest
import badlog.signals.match.files.MatchManifestException
import badlog.signals.match.files.isNameInside
import java.io.IOException
import java.nio.charset.Charset
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.text.Normalizer
import java.util.zip.CRC32
import java.util.zip.GZIPInputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipFile

/**
 * The logs in the ZIP [file], which may come from anywhere. No name in the ZIP leads out of badlog's folder, links are unpacked as ordinary
 * files, and entries that grow without end are refused. Only a `match.json`, the files that it names, and files with names of logs are
 * used.
 *
 * @throws NotReadException if it is not a ZIP, or not a plausible ZIP of logs.
 */
internal class MatchZip(private val file: Path) : AutoCloseable {
    /** A file called [name], with slashes. */
    private class Named(val name: String, val entry: ZipEntry)

    /** The files of a match: its [logs], and the `match.json`, [manifest], if there is one. */
    private class Content(val manifest: Named?, val logs: List<Named>)

    private val zip: ZipFile = opened()

    /** The unpacked size of all that grew more than [RATIO] times. */
    private var grown = 0L

    private val content: Content = try {
        contentOf(zip.entries().asSequence())
    } catch (e: Throwable) {
        zip.close()
        throw e
    }

    /** Whether anything in it may be a log. */
    val hasLogs: Boolean get() = content.manifest != null || content.logs.isNotEmpty()

    /** The text of its `match.json`; null if there is none. */
    fun manifest(): String? = content.manifest?.let(::textOf)

    /**
     * Writes its logs into [folder], and returns them by their names beside the `match.json`. Names outside of its folder begin with `../`.
     *
     * @param checkpoint called after each piece; may throw to cancel.
     */
    fun unpack(folder: Path, checkpoint: () -> Unit): Map<String, Path> {
        val folders = LinkedHashMap<String, Path>()
        var bytes = 0L
        return content.logs.associate { log ->
            val place = folders.getOrPut(log.name.substringBeforeLast('/', "")) {
                writing(folder) { Files.createDirectory(folder.resolve("${folders.size}")) }
            }
            val target = place.resolve(safeName(log.name.substringAfterLast('/')))
            bytes += copy(log, target, ALL_BYTES - bytes, checkpoint)
            bytes += inflatedBytes(log, target, ALL_BYTES - bytes, checkpoint)
            nameBeside(content.manifest, log.name) to target
        }
    }

    private fun nameBeside(manifest: Named?, name: String): String {
        val from = manifest?.name?.split('/')?.dropLast(1).orEmpty()
        val to = name.split('/')
        val common = from.zip(to.dropLast(1)).takeWhile { (one, other) -> one == other }.size
        return "../".repeat(from.size - common) + to.drop(common).joinToString("/")
    }

    override fun close(): Unit = zip.close()

    private fun opened(): ZipFile {
        for (charset in CHARSETS) {
            try {
                return ZipFile(file.toFile(), charset)
            } catch (_: IOException) {
                // Its names may be in another character set.
            } catch (_: IllegalArgumentException) {
                // As above, of some versions of Java.
            }
        }
        throw refused("This is not a ZIP that can be read; make it again.")
    }

    private fun copy(log: Named, target: Path, most: Long, checkpoint: () -> Unit): Long {
        val sum = CRC32()
        val bound = Bound(log, log.entry.compressedSize, most, checkpoint)
        val piece = ByteArray(PIECE)
        inside(log) { zip.getInputStream(log.entry) }.use { stream ->
            writing(target) { Files.newOutputStream(target, StandardOpenOption.CREATE_NEW) }.use { out ->
                while (true) {
                    val count = inside(log) { stream.read(piece) }
                    if (count < 0) break
                    bound.add(count)
                    sum.update(piece, 0, count)
                    writing(target) { out.write(piece, 0, count) }
                }
            }
        }
        if (sum.value != log.entry.crc) throw damaged(log)
        return bound.end()
    }

    /** Returns the inflated size of the log [target] if it is itself compressed; 0 otherwise. */
    private fun inflatedBytes(log: Named, target: Path, most: Long, checkpoint: () -> Unit): Long {
        val head = reading(target) { Files.newInputStream(target).use { it.readNBytes(XZ.size) } }
        if (head.contentEquals(XZ)) throw refused("“${shown(log.name)}” in it is compressed with xz; put the log itself into the ZIP.")
        val bound = Bound(log, Files.size(target), most, checkpoint)
        if (head.size < GZIP.size || GZIP.indices.any { head[it] != GZIP[it] }) return 0
        val piece = ByteArray(PIECE)
        try {
            GZIPInputStream(Files.newInputStream(target)).use { stream ->
                while (true) {
                    val count = stream.read(piece)
                    if (count < 0) break
                    bound.add(count)
                }
            }
        } catch (e: NotReadException) {
            throw e
        } catch (_: IOException) {
            // A log that was cut off is read up to its end.
        }
        return bound.end()
    }

    /** Counts the bytes of [log]; the sizes that a ZIP names may be wrong. */
    private inner class Bound(
        private val log: Named,
        private val compressed: Long,
        private val most: Long,
        private val checkpoint: () -> Unit,
    ) {
        private var size = 0L

        fun add(count: Int) {
            size += count
            if (size > most) throw tooLarge()
            if (grown + size > RATIO_COUNTS_FROM && growsFar(size, compressed)) throw grows(log.name)
            checkpoint()
        }

        /** Returns the size of the whole log. If it grew far, its size also counts for the limit of the next ones. */
        fun end(): Long {
            if (growsFar(size, compressed)) grown += size
            return size
        }
    }

    private fun beginningOf(manifest: Named): ByteArray =
        inside(manifest) { zip.getInputStream(manifest.entry).use { it.readNBytes(MANIFEST_BYTES + 1) } }

    private fun textOf(log: Named): String {
        val bytes = beginningOf(log)
        if (bytes.size > MANIFEST_BYTES) throw refused("Its ${MatchManifest.NAME} is far too large; write a new one.")
        if (CRC32().apply { update(bytes) }.value != log.entry.crc) throw damaged(log)
        return bytes.decodeToString()
    }

    private fun <T> inside(log: Named, read: () -> T): T = try {
        read()
    } catch (_: IOException) {
        throw damaged(log)
    }

    private fun contentOf(all: Sequence<ZipEntry>): Content {
        // Windows PowerShell 5 writes backslashes.
        val named = all.map { Named(it.name.replace('\\', '/').removePrefix("./"), it) }
        val files = named.filterNot { it.name.endsWith('/') || isHidden(it.name) }.toList()
        val manifest = manifestAmong(files)
        val stated = manifest?.let(::statedIn).orEmpty()
        val logs = files.filter { it !== manifest && (isNamedLikeLog(it.name) || it.name in stated) }
        if (logs.size > LOGS) throw refused("It has more than $LOGS logs; make a ZIP of one match only.")
        check(logs + listOfNotNull(manifest))
        return Content(manifest, logs)
    }

    private fun manifestAmong(files: List<Named>): Named? {
        val several = "It has several ${MatchManifest.NAME}; make a ZIP of one match only."
        val named = files.filter { it.name.substringAfterLast('/') == MatchManifest.NAME }
        if (named.size > LOGS) throw refused(several)
        val manifests = named.filter { MatchManifest.isOne(beginningOf(it).decodeToString()) }
        if (manifests.size > 1) throw refused(several)
        return manifests.singleOrNull()
    }

    /** Returns the names of the logs that [manifest] states. None if it has mistakes, which are reported when it is used. */
    private fun statedIn(manifest: Named): Set<String> = try {
        val outer = manifest.name.removeSuffix(MatchManifest.NAME)
        MatchManifest.of(beginningOf(manifest).decodeToString()).files.mapTo(HashSet()) { outer + it.name }
    } catch (_: MatchManifestException) {
        emptySet()
    }

    private fun check(files: List<Named>) {
        val seen = HashMap<String, String>()
        var bytes = 0L
        var growing = 0L
        for (file in files) {
            val (name, entry) = file.name to file.entry
            if (!isNameInside(name)) {
                throw refused("“${shown(name)}” in it is not the name of a file on every system; rename that file, and make the ZIP again.")
            }
            // Windows and macOS would take both for the same file.
            seen.put(sameOnAll(name), name)?.let { other ->
                throw refused("“${shown(other)}” and “${shown(name)}” in it are one name on some systems; rename one of them.")
            }
            bytes += maxOf(0, entry.size)
            if (bytes > ALL_BYTES) throw tooLarge()
            if (growsFar(entry.size, entry.compressedSize)) growing += entry.size
            if (growing > RATIO_COUNTS_FROM) throw grows(name)
        }
    }

    private fun refused(sentence: String) = NotReadException(ReadResult.NotRead.noLog(file, sentence))

    private fun damaged(log: Named) = refused("“${shown(log.name)}” in it is damaged; make the ZIP again.")

    private fun grows(name: String) =
        refused("“${shown(name)}” in it grows more than $RATIO times when it is read, as no log does; leave it out.")

    private fun tooLarge() = refused("Its logs have more than ${ALL_BYTES shr 30} GB together; make a ZIP of one match only.")

    private fun shown(name: String) = name.take(MAX_SHOWN)

    private companion object {
        const val LOGS = 500
        const val ALL_BYTES = 8L shl 30
        const val MANIFEST_BYTES = 1 shl 20
        const val MAX_SHOWN = 100
        const val PIECE = 1 shl 16

        /**
         * The maximum ratio of unpacked to packed size, as in packs of rules. Numbers become ten times smaller, and only zeros a thousand
         * times.
         */
        const val RATIO = 200L

        /**
         * The maximum unpacked size, in bytes, of all logs together that grow more than [RATIO] times. Small logs may be nearly empty, but
         * many of them fill a disk, too.
         */
        const val RATIO_COUNTS_FROM = 64L shl 20

        /** Returns whether [size] bytes, packed into [compressed] bytes, are compressed more than any usual log. */
        fun growsFar(size: Long, compressed: Long) = size / RATIO > compressed

        /** The first bytes of a file that is compressed with gzip. */
        val GZIP = byteArrayOf(0x1f, 0x8b.toByte())

        /**
         * The character sets to try for names. Windows writes names in its own one if they fit. Java may lack that; the last one accepts
         * all bytes.
         */
        val CHARSETS = listOfNotNull(Charsets.UTF_8, "IBM437".takeIf(Charset::isSupported)?.let(Charset::forName), Charsets.ISO_8859_1)
    }
}

private fun isNamedLikeLog(name: String) = LogName.of(name.substringAfterLast('/')).mayBeLog

/** Returns what names have in common with [name] that are the same file on some system. */
private fun sameOnAll(name: String): String =
    Normalizer.normalize(name.split('/').joinToString("/", transform = ::safeName), Normalizer.Form.NFC).lowercase()

/** Returns whether a file called [name] is hidden, or one that macOS adds to a ZIP. */
private fun isHidden(name: String): Boolean = name.split('/').any { it == "__MACOSX" || (it.startsWith(".") && it != ".." && it != ".") }
