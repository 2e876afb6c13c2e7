package badlog.catalog.match

import badlog.core.text.freeName
import badlog.files.LogName
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.files.partsOfLog
import badlog.files.reading
import badlog.files.safeName
import badlog.signals.match.files.FileRole
import badlog.signals.match.files.MatchManifest
import badlog.signals.match.files.StatedFile
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.time.LocalDateTime
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/**
 * A log for a ZIP of a match.
 *
 * @property role the program or device that wrote it; null if its content says so.
 * @property seconds the offset to add to its times to get the match's clock, in s; null if unknown.
 * @property error the possible error of [seconds], in s; null if unknown.
 */
class FileForZip(val path: Path, val role: FileRole?, val seconds: Double?, val error: Double?)

/**
 * Writes a ZIP of [files], unchanged and with all their [parts][partsOfLog], to [out], with a `match.json` that states their clocks.
 *
 * @throws NotReadException if one is compressed with xz, which is not read in a ZIP.
 */
fun writeMatchZip(files: List<FileForZip>, out: OutputStream) {
    files.flatMap { partsOfLog(it.path) }.find(::isXz)?.let { part ->
        val sentence = "$part is compressed with xz, which badlog does not read in a ZIP; make a WPILOG of it with badlog convert."
        throw NotReadException(ReadResult.NotRead.noLog(part, sentence))
    }
    val taken = hashSetOf(MatchManifest.NAME)
    val named = files.map { file ->
        val parts = partsOfLog(file.path)
        file to freeName(stemOf(file.path)) { wanted -> parts.all { taken.add("$wanted${endingOf(it)}".lowercase()) } }
    }
    ZipOutputStream(out).let { zip ->
        val stated = named.map { (file, stem) -> StatedFile(stem + endingOf(file.path), file.role, file.seconds, file.error) }
        val manifest = MatchManifest(stated)
        zip.put(MatchManifest.NAME) { it.write(manifest.text().encodeToByteArray()) }
        for ((file, stem) in named) {
            for (part in partsOfLog(file.path)) zip.put(stem + endingOf(part)) { reading(part) { Files.copy(part, it) } }
        }
        zip.finish()
    }
}

/** Returns the stem of the name of [path]. It is short enough for a number after it to remain when the ZIP is read. */
private fun stemOf(path: Path): String {
    val ending = endingOf(path)
    var stem = safeNameOf(path).removeSuffix(ending)
    while ((stem + ending).encodeToByteArray().size > MAX_BYTES) stem = stem.dropLast(if (stem.last().isLowSurrogate()) 2 else 1)
    return stem.trimEnd('.', ' ')
}

private fun endingOf(path: Path): String = safeNameOf(path).let { it.drop(LogName.of(it).stem.length) }

private fun safeNameOf(path: Path) = safeName(path.fileName.toString())

private fun isXz(path: Path): Boolean = reading(path) { Files.newInputStream(path).use { it.readNBytes(XZ.size) } }.contentEquals(XZ)

private fun ZipOutputStream.put(name: String, write: (OutputStream) -> Unit) {
    // The same logs give the same bytes.
    putNextEntry(ZipEntry(name).apply { timeLocal = BEGIN })
    write(this)
    closeEntry()
}

/** The first bytes of a file that is compressed with xz. */
internal val XZ: ByteArray = byteArrayOf(0xfd.toByte(), '7'.code.toByte(), 'z'.code.toByte(), 'X'.code.toByte(), 'Z'.code.toByte(), 0)

/** Ten less than in [safeName]. */
private const val MAX_BYTES = 170

/** The earliest time that a ZIP can hold. */
private val BEGIN = LocalDateTime.of(1980, 1, 1, 0, 0)
