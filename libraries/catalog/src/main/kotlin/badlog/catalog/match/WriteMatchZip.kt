package badlog.catalog.match

import badlog.core.text.freeName
import badlog.files.LogName
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
 * @property role what wrote it; null if its content says so.
 * @property seconds what to add to its times for the clock of the match, in s.
 * @property error the possible error of [seconds], in s; null if unknown.
 */
class FileForZip(val path: Path, val role: FileRole?, val seconds: Double, val error: Double?)

/** Writes a ZIP of [files], unchanged and with all their [parts][partsOfLog], to [out], with a `match.json` that states their clocks. */
fun writeMatchZip(files: List<FileForZip>, out: OutputStream) {
    val taken = HashSet<String>()
    val named = files.map { file ->
        val name = LogName.of(safeName(file.path.fileName.toString()))
        val stem = freeName(name.stem) { wanted -> partsOfLog(file.path).all { taken.add("$wanted${endingOf(it)}".lowercase()) } }
        file to stem
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

private fun endingOf(path: Path): String = path.fileName.toString().let { it.drop(LogName.of(it).stem.length) }

private fun ZipOutputStream.put(name: String, write: (OutputStream) -> Unit) {
    // The same logs give the same bytes.
    putNextEntry(ZipEntry(name).apply { timeLocal = BEGIN })
    write(this)
    closeEntry()
}

/** The earliest time that a ZIP can hold. */
private val BEGIN = LocalDateTime.of(1980, 1, 1, 0, 0)
