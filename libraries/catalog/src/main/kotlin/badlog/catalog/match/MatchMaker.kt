package badlog.catalog.match

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.files.LogMaker
import badlog.files.LogName
import badlog.files.NotReadException
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.UnreadableFileException
import badlog.files.inMadeFolder
import badlog.files.naming
import badlog.files.partsOfLog
import badlog.files.readLog
import badlog.files.reading
import badlog.files.wholeLogs
import badlog.files.writing
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.isOfDriverStation
import badlog.formats.revlog.RevlogFormat
import badlog.formats.wpilog.WpilogWriter
import badlog.formats.wpilog.isOfBytes
import badlog.rules.folder.FolderRules
import badlog.signals.clock.ClockedLog
import badlog.signals.match.files.FileRole
import badlog.signals.match.files.MatchFile
import badlog.signals.match.files.MatchManifest
import badlog.signals.match.files.MatchManifestException
import badlog.signals.match.files.NotOneMatchException
import badlog.signals.match.files.StatedFile
import badlog.signals.match.files.joinedMatch
import badlog.signals.match.files.missingOf
import java.io.BufferedOutputStream
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Makes one log from the logs of a match. They are in a ZIP, or beside a `match.json` that names them.
 *
 * The signal names for the folder of the ZIP or the `match.json` apply to all of its logs.
 */
object MatchMaker : LogMaker {
    override fun isSource(file: Path, head: ByteArray): Boolean {
        if (file.name == MatchManifest.NAME) return true
        if (head.size < ZIP.length || ZIP.indices.any { head[it] != ZIP[it].code.toByte() }) return false
        return try {
            MatchZip(file).use { it.hasLogs }
        } catch (_: NotReadException) {
            // The sentence about it is said when it is read.
            true
        }
    }

    /** Returns whether [file] is a ZIP or `match.json` of a match. */
    fun isSource(file: Path): Boolean = isSource(file, reading(file) { Files.newInputStream(file).use { it.readNBytes(ZIP.length) } })

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> {
        val recording = if (file.name == MatchManifest.NAME) {
            val stated = statedIn(file, textOf(file))
            joined(file, stated, logsBeside(file, stated), checkpoint)
        } else {
            inMadeFolder { folder ->
                MatchZip(file).use { zip ->
                    joined(file, zip.manifest()?.let { statedIn(file, it) }.orEmpty(), zip.unpack(folder, checkpoint), checkpoint)
                }
            }
        }
        writing(made) {
            BufferedOutputStream(Files.newOutputStream(made), BUFFER).use { out ->
                WpilogWriter(recording).write({ _, _ -> checkpoint() }) { bytes, size -> out.write(bytes, 0, size) }
            }
        }
        return recording.problems + sizesIn(recording)
    }

    /** Returns a problem about content of [recording] that its WPILOG lacks, and the logs have. */
    private fun sizesIn(recording: Recording): List<Problem> {
        val count = recording.topics.count { it.isOfBytes }
        if (count == 0) return emptyList()
        val message = "Topics of bytes that are not decoded have only their sizes here; the logs of the match have the bytes."
        return listOf(Problem(ProblemKind.NOT_DECODED, message, count = count))
    }

    /** Returns the `match.json` in [folder]; null if there is none, or only one that another program wrote. */
    fun manifestIn(folder: Path): Path? = folder.resolve(MatchManifest.NAME).takeIf { file ->
        Files.isRegularFile(file) && try {
            MatchManifest.isOne(textOf(file))
        } catch (_: UnreadableFileException) {
            // The sentence about it is said when it is used.
            true
        }
    }

    /** Returns the existing files that [manifest] names, with the second files of logs; none if it cannot be read. */
    fun filesOf(manifest: Path): Set<Path> = try {
        logsBeside(manifest, statedIn(manifest, textOf(manifest))).values.flatMapTo(HashSet(), ::partsOfLog)
    } catch (_: UnreadableFileException) {
        emptySet()
    }

    private fun textOf(manifest: Path) = reading(manifest) {
        Files.newInputStream(manifest).use { it.readNBytes(MANIFEST_BYTES) }
    }.decodeToString()

    private fun statedIn(file: Path, text: String): List<StatedFile> = try {
        MatchManifest.of(text).files
    } catch (e: MatchManifestException) {
        throw refused(file, e.message)
    }

    private fun logsBeside(manifest: Path, stated: List<StatedFile>): Map<String, Path> =
        stated.mapNotNull { file -> besideOrNull(manifest, file.name)?.let { file.name to it } }.toMap()

    private fun besideOrNull(manifest: Path, name: String): Path? = try {
        manifest.resolveSibling(name).takeIf { Files.isRegularFile(it) }
    } catch (_: InvalidPathException) {
        // Windows has no file of that name.
        null
    }

    private fun joined(file: Path, stated: List<StatedFile>, files: Map<String, Path>, checkpoint: () -> Unit): Recording {
        val signals = FolderRules.of(file).rules.signals
        val statedOf = stated.associateBy { it.name }
        val sentences = ArrayList<String>()
        var isLasting = true
        val first = wholeLogs(files.values.toList()) { it }.toSet()
        val given = files.filterValues { it in first }.mapNotNull { (name, path) ->
            checkpoint()
            when (val read = readLog(path, LOG_FORMATS, ReadOptions(name = path.name))) {
                is ReadResult.Read -> statedOf[name].let { one ->
                    MatchFile(
                        name,
                        one?.role ?: roleOf(name, read.recording),
                        ClockedLog(path.name, read.recording, signals),
                        one?.seconds,
                        one?.error,
                    )
                }

                is ReadResult.NotRead -> null.also {
                    sentences += "$name: ${read.message.replace("$path", name)}"
                    isLasting = isLasting && read.isLasting
                }
            }
        }
        return try {
            joinedMatch(given, sentences + missingOf(stated, files.keys))
        } catch (e: NotOneMatchException) {
            // With more memory, for example, the same file may be a match.
            throw if (isLasting) refused(file, e.message) else UnreadableFileException(file, naming(file, e.message))
        }
    }

    private fun refused(file: Path, sentence: String) = NotReadException(ReadResult.NotRead.noLog(file, sentence))

    private const val ZIP = "PK\u0003\u0004"
    private const val BUFFER = 1 shl 16
    private const val MANIFEST_BYTES = 1 shl 20
}

/** Returns the role of the log called [name], which contains [recording]. */
fun roleOf(name: String, recording: Recording): FileRole = when {
    recording.isOfDriverStation -> FileRole.STATION
    recording.format == RevlogFormat -> FileRole.MOTORS
    LogName.of(name.substringAfterLast('/')).ending.equals(".hoot", ignoreCase = true) -> FileRole.CAN_BUS
    else -> FileRole.ROBOT
}
