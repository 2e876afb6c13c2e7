package badlog.catalog.match

import badlog.core.recording.Problem
import badlog.core.recording.Recording
import badlog.files.FolderScan
import badlog.files.LogMaker
import badlog.files.LogName
import badlog.files.NotReadException
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.inMadeFolder
import badlog.files.isOfDriverStation
import badlog.files.readLog
import badlog.files.reading
import badlog.files.wholeLogs
import badlog.files.writing
import badlog.formats.LOG_FORMATS
import badlog.formats.revlog.RevlogFormat
import badlog.formats.wpilog.WpilogWriter
import badlog.rules.folder.FolderRules
import badlog.signals.clock.ClockedLog
import badlog.signals.match.files.FileRole
import badlog.signals.match.files.FoundMatches
import badlog.signals.match.files.MatchFile
import badlog.signals.match.files.MatchManifest
import badlog.signals.match.files.MatchManifestException
import badlog.signals.match.files.matchesOf
import badlog.signals.match.files.recording
import java.io.BufferedOutputStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.name

/**
 * Makes one log of the files of a match: those in a ZIP, or those beside a `match.json`.
 *
 * The logs of the folder are read by the signals that are beside the ZIP or the `match.json`.
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

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> {
        val recording = inMadeFolder { folder ->
            if (file.name == MatchManifest.NAME) {
                val parent = file.toAbsolutePath().parent
                val files = FolderScan.of(parent, checkpoint).files.map { it.path }
                val manifest = reading(file) { Files.newInputStream(file).use { it.readNBytes(MANIFEST_BYTES) } }.decodeToString()
                joined(file, manifest, files.associateBy { parent.relativize(it).invariantSeparatorsPathString }, checkpoint)
            } else {
                MatchZip(file).use { zip -> joined(file, zip.manifest(), zip.unpack(folder, checkpoint), checkpoint) }
            }
        }
        writing(made) {
            BufferedOutputStream(Files.newOutputStream(made), BUFFER).use { out ->
                WpilogWriter(recording).write({ _, _ -> checkpoint() }) { bytes, size -> out.write(bytes, 0, size) }
            }
        }
        return recording.problems
    }

    private fun joined(file: Path, manifest: String?, files: Map<String, Path>, checkpoint: () -> Unit): Recording {
        val stated = try {
            manifest?.let(MatchManifest::of)?.files.orEmpty().associateBy { it.name }
        } catch (e: MatchManifestException) {
            throw refused(file, e.message)
        }
        val signals = FolderRules.of(file).rules.signals
        val sentences = ArrayList<String>()
        val first = wholeLogs(files.values.toList()) { it }.toSet()
        val given = files.filterValues { it in first }.mapNotNull { (name, path) ->
            checkpoint()
            if (isVideo(name)) return@mapNotNull MatchFile(name, FileRole.VIDEO, null, stated[name]?.seconds, stated[name]?.error)
            when (val read = readLog(path, LOG_FORMATS, ReadOptions(name = path.name))) {
                is ReadResult.Read -> {
                    val role = stated[name]?.role ?: roleOf(name, read.recording)
                    MatchFile(name, role, ClockedLog(path.name, read.recording, signals), stated[name]?.seconds, stated[name]?.error)
                }

                is ReadResult.NotRead -> null.also { sentences += "$name: ${read.message.replace("$path", name)}" }
            }
        }
        val partsOfOthers = files.filterValues { it !in first }.keys
        (stated.keys - files.keys - partsOfOthers).mapTo(sentences) { "$it is missing, which ${MatchManifest.NAME} names." }
        val found = matchesOf(given)
        val match = found.matches.singleOrNull() ?: throw refused(file, sentenceFor(found, sentences))
        return match.recording(found.left.map { (_, why) -> why } + sentences)
    }

    private fun sentenceFor(found: FoundMatches, sentences: List<String>): String = if (found.matches.isEmpty()) {
        (listOf("There is no robot's log that can be read in it, with which a match begins.") + sentences).joinToString(" ")
    } else {
        "It has the logs of ${found.matches.size} matches, those of ${found.matches.joinToString { it.robot.name }}; put each match into " +
            "a folder or ZIP of its own, or state in a ${MatchManifest.NAME} how their clocks fit."
    }

    private fun roleOf(name: String, recording: Recording): FileRole = when {
        recording.isOfDriverStation -> FileRole.STATION
        recording.format == RevlogFormat -> FileRole.MOTORS
        LogName.of(name.substringAfterLast('/')).ending.equals(".hoot", ignoreCase = true) -> FileRole.CAN_BUS
        else -> FileRole.ROBOT
    }

    private fun refused(file: Path, sentence: String) = NotReadException(ReadResult.NotRead.noLog(file, sentence))

    private const val ZIP = "PK\u0003\u0004"
    private const val BUFFER = 1 shl 16
    private const val MANIFEST_BYTES = 1 shl 20
}

/** Returns whether [name] is that of a video. */
internal fun isVideo(name: String): Boolean = name.substringAfterLast('.', "").lowercase() in VIDEOS

private val VIDEOS = setOf("mp4", "mov", "m4v", "mkv", "webm", "avi")
