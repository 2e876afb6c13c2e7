package badlog.page.reading

import badlog.core.recording.Recording
import badlog.formats.driverstation.isOfDriverStation
import badlog.formats.revlog.RevlogFormat
import badlog.formats.wpilog.WpilogWriter
import badlog.signals.clock.ClockedLog
import badlog.signals.match.files.FileRole
import badlog.signals.match.files.MatchFile
import badlog.signals.match.files.MatchManifest
import badlog.signals.match.files.joinedMatch
import badlog.signals.match.files.missingOf
import badlog.signals.vocabulary.SignalVocabulary
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The files of one match.
 *
 * @property logs the files of each log, by its name beside the manifest.
 * @property manifest the text of the `match.json`; null if there is none.
 * @property names the names of all files there, beside the manifest.
 */
internal class MatchFiles(val logs: Map<String, List<File>>, val manifest: String?, val names: Set<String>)

/**
 * Reads the logs of a match one after the other, and joins them to one log. Used in the worker, or on the page if there is none.
 *
 * @param signals the names of signals in all logs.
 * @param onProgress receives the fraction of the logs that has been read.
 */
internal class MatchReader(
    private val match: MatchFiles,
    private val signals: SignalVocabulary,
    private val onProgress: (Double) -> Unit,
) {
    private val read = ArrayList<MatchFile>()
    private val sentences = ArrayList<String>()

    /** Promises the joined log, and the same as a WPILOG; rejected with a sentence if the logs are not of one match. */
    fun read(): Promise<ReadLog> {
        val stated = match.manifest?.let { MatchManifest.of(it).files }.orEmpty()
        var done = 0
        return match.logs.entries.fold(Promise.resolve(Unit)) { before, (name, files) ->
            before.then {
                LogFileReader(files) { onProgress((done + it) / match.logs.size) }.read()
            }.unsafeCast<Promise<Recording>>().then {
                done++
                val refusal = it.refusal
                if (refusal != null) {
                    sentences += "$name: $refusal"
                    return@then
                }
                val one = stated.find { file -> file.name == name }
                val log = ClockedLog(files[0].name, it, signals)
                read += MatchFile(name, one?.role ?: roleOf(it), log, one?.seconds, one?.error)
            }
        }.then {
            val unread = match.names.filter {
                it !in match.logs &&
                    (it.endsWith(".hoot", ignoreCase = true) || stated.any { one -> one.name == it })
            }
            unread.mapTo(sentences) { "$it is left out, because pages do not read it; badlog's window does." }
            val joined = joinedMatch(read, sentences + missingOf(stated, match.names))
            ReadLog(joined, isDamaged = false, wpilogOf(joined))
        }
    }

    private fun roleOf(recording: Recording) = when {
        recording.isOfDriverStation -> FileRole.STATION
        recording.format == RevlogFormat -> FileRole.MOTORS
        else -> FileRole.ROBOT
    }

    private fun wpilogOf(recording: Recording): Blob {
        val pieces = ArrayList<ByteArray>()
        WpilogWriter(recording).write { bytes, size -> pieces += bytes.copyOf(size) }
        return Blob(pieces.toTypedArray())
    }
}
